#include "experiments/studies/ablation_control.h"

#include <fmt/format.h>

#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/control_trials.h"
#include "slam/base/parallel.h"

namespace ariadne::experiments {
namespace {

using control::ApproachBehaviour;
using slam::Pose2;

/// Starts of a task each have a stream of their own.
std::uint64_t SeedOf(const AblationControlOptions& options, std::size_t start) {
  return static_cast<std::uint64_t>(options.seed) * 1'000'000'007ULL + start;
}

ControlTrial TryLaw(const Pose2& start, ApproachBehaviour behaviour,
                    const AblationControlOptions& options) {
  const std::string name =
      behaviour == ApproachBehaviour::kController ? "indiveri" : std::string(NameOf(behaviour));
  return JudgeTrial(name, SimulateApproach(start, {}, options.approach, behaviour), options.approach.limits,
                    options.approach.period);
}

ControlTrial TryPursuit(const Pose2& start, const planning::FreeSpace& space,
                        const AblationControlOptions& options, std::uint64_t seed) {
  const planning::PathResult path = PlanPath(space, start, {}, options.path, seed);
  if (path.status != planning::PathStatus::kFound) return {.controller = "pure_pursuit", .straight = 1.0};
  return JudgeTrial("pure_pursuit", SimulateFollowing(path.poses, start, options.follow),
                    options.follow.limits, options.follow.period);
}

/// A floor without anything on it.
planning::FreeSpace EmptyFloor(double distance) {
  const double half = distance + 5.0;
  const std::vector<slam::Polygon2> area{
      {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}}};
  return planning::FreeSpace(area);
}

/// Four trials per start.
std::vector<ControlTrial> TryAll(const AblationControlOptions& options, const Parallel& parallel) {
  const planning::FreeSpace space = EmptyFloor(options.distance);
  const auto count = static_cast<std::size_t>(options.starts);
  std::vector<ControlTrial> trials(4 * count);
  parallel.For(count, 1, [&](std::size_t i, std::size_t, std::size_t) {
    const Pose2 start = DrawStart(SeedOf(options, i), options.distance);
    trials[i] = TryLaw(start, ApproachBehaviour::kController, options);
    trials[count + i] = TryLaw(start, ApproachBehaviour::kTurnFirst, options);
    trials[2 * count + i] = TryLaw(start, ApproachBehaviour::kTurnStraightTurn, options);
    trials[3 * count + i] = TryPursuit(start, space, options, SeedOf(options, i));
  });
  return trials;
}

std::vector<ControlTrial> TryMany(const AblationControlOptions& options, const Parallel& parallel,
                                  ProgressDisplay& progress) {
  const auto count = static_cast<std::size_t>(options.many);
  std::vector<ControlTrial> trials(count);
  constexpr std::size_t kAtOnce = 20000;
  for (std::size_t from = 0; from < count; from += kAtOnce) {
    const double done = static_cast<double>(from) / static_cast<double>(count);
    progress.Show(fmt::format("start {} of {}, {}", from, count, progress.Eta(done)));
    parallel.For(
        std::min(kAtOnce, count - from), 100, [&](std::size_t begin, std::size_t end, std::size_t) {
          for (std::size_t i = from + begin; i < from + end; ++i) {
            const std::uint64_t seed = SeedOf(options, static_cast<std::size_t>(options.starts) + i);
            trials[i] = TryLaw(DrawStart(seed, options.distance), ApproachBehaviour::kController, options);
            trials[i].controller = "indiveri, many";
          }
        });
  }
  return trials;
}

}  // namespace

void CheckAblationControl(const AblationControlOptions& options) {
  control::RequireGains(options.approach.law);
}

std::string RunAblationControl(const AblationControlOptions& options, const RunDirectory& run,
                               ProgressDisplay& progress) {
  WriteManifest(run, {});
  const Parallel parallel(options.threads);
  progress.Show("all controllers");
  std::vector<ControlTrial> trials = TryAll(options, parallel);
  run.WriteCsv("trials.csv", ControlTrialTable(trials));
  for (ControlTrial& trial : TryMany(options, parallel, progress)) trials.push_back(std::move(trial));
  const Table table = ControlTable(trials);
  run.WriteCsv("controllers.csv", table);
  run.WriteText("controllers.tex", ToLatex(table));
  FinishRun(run, "Controllers: the paper's, its fallbacks, and pure pursuit",
            static_cast<std::size_t>(options.starts));
  return ToText(table);
}

}  // namespace ariadne::experiments
