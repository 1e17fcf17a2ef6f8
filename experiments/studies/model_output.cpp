#include "experiments/studies/model_output.h"

#include "experiments/render/mesh_view.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_cameras.h"
#include "experiments/report/model_pictures.h"
#include "experiments/studies/surface_tables.h"
#include "slam/io/cloud_io.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kModelReadme =
    "  building.dxf, .wrl   surfaces by class, boxes around objects, thinned points per scan, path\n"
    "  plan_*.dxf, .svg     points and lines at a height above the floor (the name says at which, in m)\n"
    "  mesh.ply, .glb       the smooth mesh; voxels.ply: the octree's cubes\n"
    "  leaves.ply           a point per leaf of the octree: mean, reflectance\n"
    "  map.bt               OctoMap (octovis); grid.pgm, .yaml: occupancy grid (ROS map_server)\n"
    "  surfaces.csv, objects.csv   flat surfaces, boxes around objects\n";

/// A point per leaf, for programs that know clouds. Normals are left out: leaves with few points have none.
slam::PointCloud LeafCloud(const slam::Octree& octree) {
  slam::PointCloud cloud;
  for (const slam::OctreeCell& leaf : octree.Cells(octree.max_depth())) {
    cloud.positions.push_back(leaf.mean);
    if (octree.has_reflectance()) cloud.reflectance.push_back(leaf.reflectance);
  }
  return cloud;
}

void DrawModelFigures(const RunDirectory& run, const BuildingModel& model,
                      const std::vector<slam::PosedCloud>& scans, int width) {
  const Camera camera = ObliqueCamera(scans, width);
  const double cut = WithoutCeiling(scans).max;
  std::vector<slam::OctreeCell> cells = model.octree.Cells(model.octree.max_depth());
  std::erase_if(cells, [&](const slam::OctreeCell& cell) { return cell.mean.z() > cut; });
  WritePng(run.File("figures/voxels.png"), VoxelPicture(cells, model.octree.has_reflectance(), camera));
  const slam::SurfaceModel opened = WithoutCeiling(model.surfaces);
  if (!opened.surfaces_map.empty())
    WritePng(run.File("figures/surfaces.png"), ModelPicture(opened, camera));
  if (model.mesh.triangles.empty()) return;
  const slam::TriangleMesh lower = MeshBelow(model.mesh, cut);
  WritePng(run.File("figures/mesh.png"), RenderMesh(lower, camera, {}, Parallel(1)));
}

}  // namespace

std::string ModelReadme() { return kModelReadme; }

void WriteBuildingModel(const RunDirectory& run, const BuildingModel& model,
                        const std::vector<slam::PosedCloud>& clouds, const ModelOptions& options,
                        const ModelStep& step) {
  slam::WriteCloud(run.File("leaves.ply"), LeafCloud(model.octree));
  run.WriteCsv("surfaces.csv", SurfaceTable(model.surfaces));
  run.WriteCsv("objects.csv", ObjectTable(model.surfaces));
  step("drawings", [&] { WriteDrawings(run, model.surfaces, clouds, options); });
  step("meshes", [&] { WriteMeshes(run, model.octree, model.mesh); });
  step("grids", [&] { WriteGrids(run, FloorOf(model.surfaces), clouds, options); });
  step("figures", [&] { DrawModelFigures(run, model, clouds, options.picture_width); });
}

Json ToJson(const BuildingModel& model) {
  const slam::Octree& octree = model.octree;
  const slam::SurfaceModel& surfaces = model.surfaces;
  Json classes;
  for (std::size_t c = 0; c < EnumNames<slam::SurfaceClass>::value.size(); ++c) {
    double area = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < surfaces.classes.size(); ++i) {
      if (static_cast<std::size_t>(surfaces.classes[i]) != c) continue;
      area += slam::Area(surfaces.surfaces_map[i]);
      ++count;
    }
    classes[std::string(EnumNames<slam::SurfaceClass>::value[c])] = {{"surfaces", count},
                                                                     {"area_m2", area}};
  }
  return {{"points", octree.points()},
          {"leaves", octree.leaves()},
          {"octree_bytes_per_point",
           static_cast<double>(octree.bytes()) / static_cast<double>(octree.points())},
          {"surfaces", classes},
          {"objects", surfaces.objects.size()},
          {"mesh_triangles", model.mesh.triangles.size()}};
}

}  // namespace ariadne::experiments
