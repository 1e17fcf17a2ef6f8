#include "experiments/studies/explore_model.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kExploreReadme =
    "The mission\n"
    "  report.html          open it in a browser\n"
    "  robot.log            all calls to the robot with its answers; --resume and replays go by it\n"
    "  scans/, poses.txt    the scans, and where they came to lie; for ariadne map, export and plan\n"
    "  steps/               what was known after each scan and planned from there: .svg, .json\n"
    "  stops.csv            a line per scan; metrics.json: how it went; trajectory.tum, truth.tum\n"
    "  exploration.svg      the way over the walls as they are; map.ply: all points\n"
    "The model of the building; model.json has its counts\n";

}  // namespace

std::vector<slam::PosedCloud> ModelScans(const MissionResult& result,
                                         const slam::ScanFilterOptions& range) {
  std::vector<slam::PosedCloud> scans;
  for (std::size_t i = 0; i < result.scans.size(); ++i) {
    if (!result.registered[i]) continue;
    const slam::PosedCloud& scan = result.scans[i];
    scans.push_back({scan.name, slam::WithinRange(scan.cloud_laser, range.min_range, range.max_range),
                     scan.T_map_laser});
  }
  return scans;
}

BuildingModel IntegrateScans(const std::vector<slam::PosedCloud>& scans, const ModelOptions& options) {
  BuildingModel model{slam::Octree(options.octree), {}, {}};
  std::vector<slam::PlanarSurface> surfaces_map;
  for (const slam::PosedCloud& scan : scans) {
    model.octree.Add(slam::Transformed(scan.T_map_laser, scan.cloud_laser), scan.T_map_laser.translation);
    for (slam::PlanarSurface& surface : slam::SurfacesInMap(scan, options.surfaces.extract))
      surfaces_map.push_back(std::move(surface));
  }
  model.surfaces = slam::MakeSurfaceModel(std::move(surfaces_map), options.surfaces);
  model.mesh = MakeMesh(scans, options);
  return model;
}

BuildingModel WriteExploredModel(const MissionResult& result, const slam::ScanFilterOptions& range,
                                 const ModelOptions& options, const RunDirectory& run,
                                 ProgressDisplay& progress) {
  progress.Show("the model: surfaces, octree, mesh");
  const std::vector<slam::PosedCloud> scans = ModelScans(result, range);
  BuildingModel model = IntegrateScans(scans, options);
  WriteBuildingModel(run, model, scans, options,
                     [&](const std::string& name, const std::function<void()>& work) {
                       progress.Show("the model: " + name);
                       work();
                     });
  run.WriteJson("model.json", ToJson(model));
  run.WriteText("README.txt", kExploreReadme + ModelReadme());
  return model;
}

}  // namespace ariadne::experiments
