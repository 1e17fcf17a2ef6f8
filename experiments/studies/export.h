#pragma once

#include <filesystem>

#include "experiments/run/run_directory.h"
#include "experiments/studies/building_model.h"
#include "slam/io/export.h"

namespace ariadne::experiments {

/// The smooth mesh of scans with slices; empty where one of them has none.
slam::TriangleMesh MakeMesh(std::span<const slam::PosedCloud> scans, const ModelOptions& options);

/// The triangles whose corners are all below a height [m].
slam::TriangleMesh MeshBelow(const slam::TriangleMesh& mesh, double height);

/// The 3D drawing as DXF and VRML, and plans at their heights as DXF and SVG.
void WriteDrawings(const RunDirectory& run, const slam::SurfaceModel& model,
                   std::span<const slam::PosedCloud> scans, const ModelOptions& options);

void WriteMeshes(const RunDirectory& run, const slam::Octree& octree, const slam::TriangleMesh& mesh);

/// OctoMap, and the occupancy grid over a floor at this z.
void WriteGrids(const RunDirectory& run, double floor, std::span<const slam::PosedCloud> scans,
                const ModelOptions& options);

/// What of a model is exported.
enum class ExportPart {
  kModel,   // the building: surfaces and boxes, with points and path where the format has them
  kPlan,    // points and lines at a height
  kMesh,    // the smooth mesh
  kVoxels,  // the cubes of the octree
  kGrid,    // OctoMap or occupancy grid
};

/// Writes a part of the model of a run in a format. Error where the format cannot hold it, with those that
/// can. A plan is the one at the last of options.plan_heights.
void ExportRun(const std::filesystem::path& run, slam::ExportFormat format, ExportPart part,
               const ModelOptions& options, const std::filesystem::path& file,
               const ModelProgress& progress);

/// The part that a format is for.
ExportPart UsualPart(slam::ExportFormat format);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::ExportPart> {
  static constexpr std::array<std::string_view, 5> value{"model", "plan", "mesh", "voxels", "grid"};
};

}  // namespace ariadne
