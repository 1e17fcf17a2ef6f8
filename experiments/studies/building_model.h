#pragma once

#include <filesystem>
#include <functional>

#include "experiments/studies/model_options.h"
#include "experiments/studies/run_scans.h"

namespace ariadne::experiments {

/// Called before each scan, with what is done and a share of it.
using ModelProgress = std::function<void(const std::string& step, std::size_t done, std::size_t total)>;

// The forms of a model, each made of the scans of a run. The octree reads one scan at a time.

slam::Octree MakeOctree(const RunScans& scans, const ModelOptions& options, const ModelProgress& progress);

slam::SurfaceModel MakeSurfaces(const RunScans& scans, const ModelOptions& options,
                                const ModelProgress& progress);

/// The heights of options.plan_heights above the floor.
std::vector<double> PlanHeights(const ModelOptions& options);

/// z of the floor that the surfaces show; 0 where they show none.
double FloorOf(const slam::SurfaceModel& model);

/// The point and line map at a height [m] above a floor at this z, with the path of the laser in the layer
/// "path".
slam::Drawing PlanAt(double height, double floor, std::span<const slam::PosedCloud> scans,
                     const ModelOptions& options);

/// The occupancy grid over a floor at this z.
slam::OccupancyGrid MakeGrid(double floor, std::span<const slam::PosedCloud> scans,
                             const ModelOptions& options);

/// Surfaces and boxes by class, thinned points per scan, and the path.
slam::Drawing MakeDrawing(const slam::SurfaceModel& model, std::span<const slam::PosedCloud> scans,
                          const ModelOptions& options);

}  // namespace ariadne::experiments
