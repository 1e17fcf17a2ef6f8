#include "experiments/studies/export.h"

#include <fmt/format.h>

#include <algorithm>

#include "slam/base/error.h"
#include "slam/io/dxf.h"
#include "slam/io/gltf.h"
#include "slam/io/occupancy_grid_file.h"
#include "slam/io/octomap_file.h"
#include "slam/io/ply_mesh.h"
#include "slam/io/svg.h"
#include "slam/io/vrml.h"
#include "slam/map/voxel_mesh.h"

namespace ariadne::experiments {
namespace {

using slam::ExportFormat;

slam::TriangleMesh Voxels(const slam::Octree& octree) {
  const slam::VoxelMeshOptions options{octree.has_reflectance() ? slam::VoxelColoring::kReflectance
                                                                : slam::VoxelColoring::kHeight};
  return slam::VoxelMesh(octree.Cells(octree.max_depth()), options);
}

/// A mesh as a drawing of one layer, for formats of drawings.
slam::Drawing AsDrawing(const std::string& name, slam::TriangleMesh mesh) {
  return {{{name, {160, 160, 160}, {}, {}, std::move(mesh)}}};
}

void WriteDrawing(const std::filesystem::path& file, ExportFormat format, const slam::Drawing& drawing,
                  const ModelOptions& options) {
  if (format == ExportFormat::kDxf) return slam::WriteDxf(file, drawing);
  if (format == ExportFormat::kSvg) return slam::WriteSvg(file, drawing, options.svg);
  slam::WriteVrml(file, drawing);
}

/// In a format of meshes or of drawings.
void WriteMesh(const std::filesystem::path& file, ExportFormat format, const std::string& name,
               slam::TriangleMesh mesh, const ModelOptions& options) {
  if (format == ExportFormat::kPly) return slam::WritePlyMesh(file, mesh);
  if (format == ExportFormat::kGlb) return slam::WriteGlb(file, mesh);
  WriteDrawing(file, format, AsDrawing(name, std::move(mesh)), options);
}

/// What the content of a format can be.
std::vector<ExportPart> PartsOf(ExportFormat format) {
  switch (slam::InfoOf(format).content) {
    case slam::ExportContent::kDrawing:
      return {ExportPart::kModel, ExportPart::kPlan, ExportPart::kMesh, ExportPart::kVoxels};
    case slam::ExportContent::kPlan:
      return {ExportPart::kPlan};
    case slam::ExportContent::kMesh:
      return {ExportPart::kMesh, ExportPart::kModel, ExportPart::kVoxels};
    case slam::ExportContent::kScans:
    case slam::ExportContent::kGrid:
      break;
  }
  return {ExportPart::kGrid};
}

void RequireFits(ExportFormat format, ExportPart part) {
  const std::vector<ExportPart> parts = PartsOf(format);
  if (std::ranges::find(parts, part) != parts.end()) return;
  std::string names;
  for (const ExportPart possible : parts)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", NameOf(possible));
  Fail("{} files hold no {}; they hold: {}", slam::InfoOf(format).name, NameOf(part), names);
}

slam::TriangleMesh RequiredMesh(std::span<const slam::PosedCloud> scans, const ModelOptions& options) {
  slam::TriangleMesh mesh = MakeMesh(scans, options);
  if (mesh.triangles.empty())
    Fail("there is no smooth mesh: the files of these scans do not tell their slices; export voxels");
  return mesh;
}

}  // namespace

slam::TriangleMesh MakeMesh(std::span<const slam::PosedCloud> scans, const ModelOptions& options) {
  const auto has_slices = [](const slam::PosedCloud& scan) { return scan.cloud_laser.organized(); };
  if (!std::ranges::all_of(scans, has_slices)) return {};
  return slam::MeshOfScans(scans, options.mesh);
}

slam::TriangleMesh MeshBelow(const slam::TriangleMesh& mesh, double height) {
  slam::TriangleMesh below = mesh;
  std::erase_if(below.triangles, [&](const auto& triangle) {
    return std::ranges::any_of(triangle, [&](std::uint32_t v) { return mesh.vertices[v].z() > height; });
  });
  return below;
}

void WriteDrawings(const RunDirectory& run, const slam::SurfaceModel& model,
                   std::span<const slam::PosedCloud> scans, const ModelOptions& options) {
  const slam::Drawing building = MakeDrawing(model, scans, options);
  slam::WriteDxf(run.File("building.dxf"), building);
  slam::WriteVrml(run.File("building.wrl"), building);
  for (const double height : PlanHeights(options)) {
    const slam::Drawing plan = PlanAt(height, FloorOf(model), scans, options);
    slam::WriteDxf(run.File(fmt::format("plan_{:.2f}.dxf", height)), plan);
    slam::WriteSvg(run.File(fmt::format("plan_{:.2f}.svg", height)), plan, options.svg);
  }
}

void WriteMeshes(const RunDirectory& run, const slam::Octree& octree, const slam::TriangleMesh& mesh) {
  slam::WritePlyMesh(run.File("voxels.ply"), Voxels(octree));
  if (mesh.triangles.empty()) return;
  slam::WritePlyMesh(run.File("mesh.ply"), mesh);
  slam::WriteGlb(run.File("mesh.glb"), mesh);
}

void WriteGrids(const RunDirectory& run, double floor, std::span<const slam::PosedCloud> scans,
                const ModelOptions& options) {
  slam::WriteOctoMap(run.File("map.bt"), scans, options.octomap);
  slam::WriteOccupancyGrid(run.File("grid.pgm"), MakeGrid(floor, scans, options));
}

ExportPart UsualPart(ExportFormat format) { return PartsOf(format).front(); }

void ExportRun(const std::filesystem::path& run, ExportFormat format, ExportPart part,
               const ModelOptions& options, const std::filesystem::path& file,
               const ModelProgress& progress) {
  RequireFits(format, part);
  const RunScans source(run);
  if (part == ExportPart::kVoxels)
    return WriteMesh(file, format, "voxels", Voxels(MakeOctree(source, options, progress)), options);
  const std::vector<slam::PosedCloud> scans = ReadRegisteredMap(run).scans;
  if (part == ExportPart::kMesh)
    return WriteMesh(file, format, "mesh", RequiredMesh(scans, options), options);
  if (slam::InfoOf(format).content == slam::ExportContent::kScans)
    return slam::WriteOctoMap(file, scans, options.octomap);
  const slam::SurfaceModel model = MakeSurfaces(source, options, progress);
  if (part == ExportPart::kGrid)
    return slam::WriteOccupancyGrid(file, MakeGrid(FloorOf(model), scans, options));
  if (part == ExportPart::kPlan) {
    const double height = PlanHeights(options).back();
    return WriteDrawing(file, format, PlanAt(height, FloorOf(model), scans, options), options);
  }
  if (slam::InfoOf(format).content == slam::ExportContent::kMesh)
    return WriteMesh(file, format, "surfaces", slam::MeshOf(model), options);
  WriteDrawing(file, format, MakeDrawing(model, scans, options), options);
}

}  // namespace ariadne::experiments
