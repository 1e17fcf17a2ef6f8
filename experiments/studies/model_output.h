#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/run/run_directory.h"
#include "experiments/studies/export.h"

namespace ariadne::experiments {

/// A building, as its registered scans show it.
struct BuildingModel {
  slam::Octree octree;
  slam::SurfaceModel surfaces;
  slam::TriangleMesh mesh;  // empty where scans do not tell their slices
};

/// Does a step that has a name, and may keep its time.
using ModelStep = std::function<void(const std::string& name, const std::function<void()>& work)>;

/// What WriteBuildingModel leaves, a line per kind of files.
std::string ModelReadme();

/// Writes a model in all its forms, with pictures and tables. `clouds` are the scans that it was made of.
void WriteBuildingModel(const RunDirectory& run, const BuildingModel& model,
                        const std::vector<slam::PosedCloud>& clouds, const ModelOptions& options,
                        const ModelStep& step);

/// How many points, voxels, surfaces by class, boxes and triangles there are.
Json ToJson(const BuildingModel& model);

}  // namespace ariadne::experiments
