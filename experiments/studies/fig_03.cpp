#include "experiments/studies/fig_03.h"

#include <fmt/format.h>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"
#include "slam/reduce/reduce.h"

namespace ariadne::experiments {
namespace {

/// The pair at one of the three poses.
struct Stage {
  std::string title;
  slam::Pose3 T_model_data;
};

std::vector<slam::PosedCloud> Place(const ScanPair& pair, const slam::Pose3& T_model_data) {
  return {{pair.model_name, pair.model, {}}, {pair.data_name, pair.data, T_model_data}};
}

slam::AlignResult AlignReduced(const ScanPair& pair, const Fig03Options& options, int max_iterations) {
  slam::AlignOptions icp = options.icp;
  icp.max_iterations = max_iterations;
  return slam::Align(slam::Reduce(pair.model, options.reduce), slam::Reduce(pair.data, options.reduce),
                     pair.T_model_data_guess, icp);
}

std::string Describe(const Stage& stage, const slam::Pose3& T_model_data_final) {
  return fmt::format("{}: {:.2f} cm and {:.3f} deg from the final pose\n", stage.title,
                     100.0 * slam::TranslationDistance(stage.T_model_data, T_model_data_final),
                     slam::DegFromRad(slam::RotationDistance(stage.T_model_data, T_model_data_final)));
}

}  // namespace

std::string RunFig03(const Fig03Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  const ScanPair pair = ReadScanPair(options);
  WriteManifest(run, pair.files);
  run.WriteProgress("running", 0, 1);
  const slam::AlignResult during = AlignReduced(pair, options, options.iterations);
  const slam::AlignResult final = AlignReduced(pair, options, options.icp.max_iterations);
  if (!final.converged() && final.status != slam::AlignStatus::kDegenerate)
    Fail("fig_03: {}", final.message);
  const std::vector<Stage> stages{
      {"Odometry", pair.T_model_data_guess},
      {fmt::format("After {} iterations", options.iterations), during.T_model_data},
      {fmt::format("After {} iterations", final.iterations.size()), final.T_model_data}};
  const std::vector<slam::PosedCloud> frame = Place(pair, final.T_model_data);
  std::vector<Image> tops, obliques;
  std::string text;
  Json metrics = Json::array();
  for (const Stage& stage : stages) {
    progress.Keep(stage.title);
    tops.push_back(PlainTopPicture(Place(pair, stage.T_model_data), frame, stage.title));
    obliques.push_back(ScanObliquePicture(Place(pair, stage.T_model_data), frame, stage.title));
    text += Describe(stage, final.T_model_data);
    const Eigen::Vector3d& t = stage.T_model_data.translation;
    const Eigen::Quaterniond& q = stage.T_model_data.rotation;
    metrics.push_back(
        {{"title", stage.title}, {"T_model_data", {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}}});
  }
  WritePng(run.File("figures/top.png"), Grid(tops, {.columns = 1}));
  WritePng(run.File("figures/oblique.png"), Grid(obliques, {.columns = 3}));
  run.WriteJson("metrics.json", {{"stages", metrics},
                                 {"iterations", final.iterations.size()},
                                 {"pairs", final.pairs},
                                 {"rms_m", final.rms}});
  FinishRun(run, "Fig. 3: two scans before, during and after ICP", 1);
  return text;
}

}  // namespace ariadne::experiments
