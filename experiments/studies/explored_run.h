#pragma once

#include <filesystem>

#include "experiments/studies/explore.h"
#include "experiments/studies/explore_steps.h"
#include "slam/scan/scan.h"

namespace ariadne::experiments {

/// For figures, which make models of their own.
inline ExploreStudyOptions ExplorationWithoutModel() {
  ExploreStudyOptions options;
  options.integrate = false;
  return options;
}

/// Whose exploration a figure shows.
struct ExploredRunOptions {
  std::string run;
  ExploreStudyOptions explore = ExplorationWithoutModel();

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("run", self.run,
          "directory of a finished run of `explore`; empty: explores first, in the folder exploration of "
          "this "
          "run");
    visit("explore", self.explore, "the exploration, where it is not that of a run");
  }
};

/// Error where there is no such run, or the exploration could not begin.
void CheckExploredRun(const ExploredRunOptions& options);

/// The directory of the exploration, which is made, or made to its end, where options.run is empty.
std::filesystem::path ExploredRunFor(const ExploredRunOptions& options, const RunDirectory& run,
                                     ProgressDisplay& progress);

/// What an exploration has left.
struct ExploredRun {
  std::vector<ExploredStep> steps;
  std::vector<slam::PosedCloud> scans;  // where they came to lie; all of them
};

/// The scans that could be registered.
std::vector<slam::PosedCloud> RegisteredScans(const ExploredRun& explored);

/// Error where the directory holds no finished run of `explore`.
ExploredRun ReadExploredRun(const std::filesystem::path& path);

/// The first scans of a run as the robot took them, at most `count`, from its log.
std::vector<slam::Scan> ReadScansAsTaken(const std::filesystem::path& path, std::size_t count);

/// The way that was driven, up to the stop of a step, the last included.
std::vector<Eigen::Vector2d> DrivenUpTo(const std::vector<ExploredStep>& steps, std::size_t last);

}  // namespace ariadne::experiments
