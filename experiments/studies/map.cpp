#include "experiments/studies/map.h"

#include <fmt/format.h>

#include "experiments/report/viewer.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/model_output.h"
#include "slam/base/error.h"
#include "slam/base/stopwatch.h"

namespace ariadne::experiments {
namespace {

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

/// The points with the boxes around objects and the mesh.
PageSection ViewOf(const std::vector<slam::PosedCloud>& scans, const BuildingModel& model) {
  ViewerScene scene = SceneOf(scans);
  for (const slam::ObjectBox& object : model.surfaces.objects) scene.boxes.push_back({object.box, {}, 0});
  scene.mesh_map = model.mesh;
  return ViewerSection(scene, "The model in 3D");
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
  BuildingModel model{step("octree", [&] { return MakeOctree(scans, model_options, step.OnScan()); }),
                      step("surfaces", [&] { return MakeSurfaces(scans, model_options, step.OnScan()); }),
                      {}};
  const std::vector<slam::PosedCloud> clouds = ReadRegisteredMap(options.run).scans;
  model.mesh = step("mesh", [&] { return MakeMesh(clouds, model_options); });
  WriteBuildingModel(run, model, clouds, model_options, std::ref(step));
  const Json metrics = ToJson(model);
  run.WriteJson("metrics.json", metrics);
  run.WriteJson("timing.json", step.timing());
  run.WriteText("README.txt", "What is what here\n" + ModelReadme() +
                                  "  metrics.json, timing.json, figures/, report.html\n");
  FinishRun(run, "A model of the building", kSteps, ViewOf(clouds, model));
  std::string text =
      fmt::format("{} points in {} voxels, {} objects, {} triangles\n", model.octree.points(),
                  model.octree.leaves(), model.surfaces.objects.size(), model.mesh.triangles.size());
  for (const auto& [name, value] : metrics["surfaces"].items()) {
    text += fmt::format("{:>8}: {:4} surfaces, {:8.1f} m^2\n", name, value["surfaces"].get<std::size_t>(),
                        value["area_m2"].get<double>());
  }
  if (model.mesh.triangles.empty())
    text += "no smooth mesh: the files of these scans do not tell their slices\n";
  return text;
}

}  // namespace ariadne::experiments
