#include "experiments/studies/explored_run.h"

#include <fmt/format.h>

#include "drivers/replay/robot_log.h"
#include "experiments/config/options_io.h"
#include "experiments/studies/run_scans.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

bool IsFinished(const std::filesystem::path& path) {
  if (!HoldsRun(path)) return false;
  const RunDirectory run(path, RunDirectory::Existing::kResume);
  return Json::parse(run.ReadText("progress.json")).value("state", "") == "finished";
}

}  // namespace

void CheckExploredRun(const ExploredRunOptions& options) {
  if (options.run.empty()) return CheckExplore(options.explore);
  ReadSteps(options.run);
  const RunScans scans(options.run);
}

std::filesystem::path ExploredRunFor(const ExploredRunOptions& options, const RunDirectory& run,
                                     ProgressDisplay& progress) {
  if (!options.run.empty()) return options.run;
  std::filesystem::path path = run.path() / "exploration";
  if (IsFinished(path)) return path;
  const RunDirectory inner(
      path, HoldsRun(path) ? RunDirectory::Existing::kResume : RunDirectory::Existing::kRefuse);
  inner.WriteConfig(fmt::format("experiment: explore\n{}", WriteOptions(options.explore)));
  RunExplore(options.explore, inner, progress);
  return path;
}

ExploredRun ReadExploredRun(const std::filesystem::path& path) {
  ExploredRun explored{ReadSteps(path), ReadRegisteredMap(path).scans};
  if (explored.steps.size() != explored.scans.size())
    Fail("{}: {} scans, but {} steps", path.string(), explored.scans.size(), explored.steps.size());
  return explored;
}

std::vector<slam::PosedCloud> RegisteredScans(const ExploredRun& explored) {
  std::vector<slam::PosedCloud> scans;
  for (std::size_t i = 0; i < explored.scans.size(); ++i) {
    if (explored.steps[i].registered) scans.push_back(explored.scans[i]);
  }
  return scans;
}

std::vector<slam::Scan> ReadScansAsTaken(const std::filesystem::path& path, std::size_t count) {
  drivers::RobotLog log = drivers::ReadRobotLog(path / "robot.log");
  std::vector<slam::Scan> scans;
  for (std::size_t i = 0; i < log.size() && scans.size() < count; ++i) {
    if (log.KindAt(i) == drivers::CallKind::kScan)
      scans.push_back(std::get<drivers::ScanCall>(log.Read(i)).scan);
  }
  return scans;
}

std::vector<Eigen::Vector2d> DrivenUpTo(const std::vector<ExploredStep>& steps, std::size_t last) {
  std::vector<Eigen::Vector2d> way;
  for (std::size_t i = 0; i <= last && i < steps.size(); ++i)
    way.insert(way.end(), steps[i].driven_map.begin(), steps[i].driven_map.end());
  return way;
}

}  // namespace ariadne::experiments
