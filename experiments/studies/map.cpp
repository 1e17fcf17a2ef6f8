#include "experiments/studies/map.h"

#include <fmt/format.h>

#include "experiments/render/mesh_view.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_cameras.h"
#include "experiments/report/model_pictures.h"
#include "experiments/report/viewer.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/building_model.h"
#include "experiments/studies/export.h"
#include "experiments/studies/surface_tables.h"
#include "slam/base/error.h"
#include "slam/base/stopwatch.h"
#include "slam/io/cloud_io.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kReadme =
    "What is what here\n"
    "  building.dxf, .wrl   surfaces by class, boxes around objects, thinned points per scan, path\n"
    "  plan_*.dxf, .svg     points and lines at a height above the floor (the name says at which, in m)\n"
    "  mesh.ply, .glb       the smooth mesh; voxels.ply: the octree's cubes\n"
    "  leaves.ply           a point per leaf of the octree: mean, reflectance\n"
    "  map.bt               OctoMap (octovis); grid.pgm, .yaml: occupancy grid (ROS map_server)\n"
    "  surfaces.csv, objects.csv, metrics.json, timing.json, figures/, report.html\n";

/// Does the steps of a run one after another, and keeps their times.
class Steps {
 public:
  Steps(const RunDirectory& run, ProgressDisplay& progress, std::size_t total)
      : run_(run), progress_(progress), total_(total) {}

  template <typename Work>
  auto operator()(const std::string& name, const Work& work) {
    run_.WriteProgress("running", done_++, total_);
    progress_.Show(fmt::format("{} ({} of {})", name, done_, total_));
    const Stopwatch watch;
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      timing_[name + "_s"] = watch.Seconds();
    } else {
      auto result = work();
      timing_[name + "_s"] = watch.Seconds();
      return result;
    }
  }
  ModelProgress OnScan() {
    return [this](const std::string& step, std::size_t done, std::size_t total) {
      progress_.Show(fmt::format("{}: scan {} of {}", step, done + 1, total));
    };
  }
  const Json& timing() const { return timing_; }

 private:
  const RunDirectory& run_;
  ProgressDisplay& progress_;
  std::size_t total_;
  std::size_t done_ = 0;
  Json timing_;
};

/// A point per leaf, for programs that know clouds. Normals are left out: leaves with few points have none.
slam::PointCloud LeafCloud(const slam::Octree& octree) {
  slam::PointCloud cloud;
  for (const slam::OctreeCell& leaf : octree.Cells(octree.max_depth())) {
    cloud.positions.push_back(leaf.mean);
    if (octree.has_reflectance()) cloud.reflectance.push_back(leaf.reflectance);
  }
  return cloud;
}

void DrawFigures(const RunDirectory& run, const std::vector<slam::PosedCloud>& scans,
                 const slam::Octree& octree, const slam::SurfaceModel& model,
                 const slam::TriangleMesh& mesh) {
  const Camera camera = ObliqueCamera(scans);
  const double cut = WithoutCeiling(scans).max;
  std::vector<slam::OctreeCell> cells = octree.Cells(octree.max_depth());
  std::erase_if(cells, [&](const slam::OctreeCell& cell) { return cell.mean.z() > cut; });
  WritePng(run.File("figures/voxels.png"), VoxelPicture(cells, octree.has_reflectance(), camera));
  const slam::SurfaceModel opened = WithoutCeiling(model);
  if (!opened.surfaces_map.empty())
    WritePng(run.File("figures/surfaces.png"), ModelPicture(opened, camera));
  if (mesh.triangles.empty()) return;
  const slam::TriangleMesh lower = MeshBelow(mesh, cut);
  WritePng(run.File("figures/mesh.png"), RenderMesh(lower, camera, {}, Parallel(1)));
}

/// The points with the boxes around objects and the mesh.
PageSection ViewOf(const std::vector<slam::PosedCloud>& scans, const slam::SurfaceModel& model,
                   const slam::TriangleMesh& mesh) {
  ViewerScene scene = SceneOf(scans);
  for (const slam::ObjectBox& object : model.objects) scene.boxes.push_back({object.box, {}, 0});
  scene.mesh_map = mesh;
  return ViewerSection(scene, "The model in 3D");
}

Json MetricsOf(const slam::Octree& octree, const slam::SurfaceModel& model,
               const slam::TriangleMesh& mesh) {
  Json classes;
  for (std::size_t c = 0; c < EnumNames<slam::SurfaceClass>::value.size(); ++c) {
    double area = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < model.classes.size(); ++i) {
      if (static_cast<std::size_t>(model.classes[i]) != c) continue;
      area += slam::Area(model.surfaces_map[i]);
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
          {"objects", model.objects.size()},
          {"mesh_triangles", mesh.triangles.size()}};
}

}  // namespace

void CheckMapInput(const MapStudyOptions& options) {
  if (options.run.empty()) Fail("which run? Set run=DIR, the directory of a run of `register`");
  RunScans{options.run};
}

std::string RunMap(const MapStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress) {
  const RunScans scans(options.run);
  WriteManifest(run, scans.source().Files());
  const ModelOptions& model_options = options.model;
  constexpr std::size_t kSteps = 7;
  Steps step(run, progress, kSteps);
  const slam::Octree octree =
      step("octree", [&] { return MakeOctree(scans, model_options, step.OnScan()); });
  const slam::SurfaceModel model =
      step("surfaces", [&] { return MakeSurfaces(scans, model_options, step.OnScan()); });
  slam::WriteCloud(run.File("leaves.ply"), LeafCloud(octree));
  run.WriteCsv("surfaces.csv", SurfaceTable(model));
  run.WriteCsv("objects.csv", ObjectTable(model));

  const std::vector<slam::PosedCloud> clouds = ReadRegisteredMap(options.run).scans;
  const slam::TriangleMesh mesh = step("mesh", [&] { return MakeMesh(clouds, model_options); });
  step("drawings", [&] { WriteDrawings(run, model, clouds, model_options); });
  step("meshes", [&] { WriteMeshes(run, octree, mesh); });
  step("grids", [&] { WriteGrids(run, FloorOf(model), clouds, model_options); });
  step("figures", [&] { DrawFigures(run, clouds, octree, model, mesh); });
  run.WriteText("README.txt", kReadme);
  const Json metrics = MetricsOf(octree, model, mesh);
  run.WriteJson("metrics.json", metrics);
  run.WriteJson("timing.json", step.timing());
  FinishRun(run, "A model of the building", kSteps, ViewOf(clouds, model, mesh));
  std::string text = fmt::format("{} points in {} voxels, {} objects, {} triangles\n", octree.points(),
                                 octree.leaves(), model.objects.size(), mesh.triangles.size());
  for (const auto& [name, value] : metrics["surfaces"].items()) {
    text += fmt::format("{:>8}: {:4} surfaces, {:8.1f} m^2\n", name, value["surfaces"].get<std::size_t>(),
                        value["area_m2"].get<double>());
  }
  if (mesh.triangles.empty()) text += "no smooth mesh: the files of these scans do not tell their slices\n";
  return text;
}

}  // namespace ariadne::experiments
