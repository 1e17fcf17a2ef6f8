#pragma once

#include <string>

#include "control/pure_pursuit.h"
#include "control/simulate_approach.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "planning/path/plan_path.h"

namespace ariadne::experiments {

/// The experiment `ablation_control`: the paper's controller, its fallbacks, and regulated pure pursuit
/// along a planned path, from the same random starts to one pose, where nothing is in the way.
struct AblationControlOptions {
  control::ApproachOptions approach;
  control::FollowOptions follow;
  planning::PathOptions path;
  int starts = 1000;
  int many = 20000;
  double distance = 10.0;
  int seed = 1;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("approach", self.approach, "the paper's controller");
    visit("follow", self.follow, "pure pursuit");
    visit("path", self.path, "what pure pursuit follows");
    visit("starts", self.starts, Unit(""), Range{1, 1e6}, "for all controllers");
    visit("many", self.many, Unit(""), Range{0, 1e8}, "further starts, for the paper's controller alone");
    visit("distance", self.distance, Unit("m"), Range{0.05, 1000.0}, "of a start from the goal, at most");
    visit("seed", self.seed, Unit(""), Range{0, 1e9}, "of the starts");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "the result does not depend on it");
  }
};

/// Error where the controller's gains do not end its paths straight.
void CheckAblationControl(const AblationControlOptions& options);

/// Returns what to print.
std::string RunAblationControl(const AblationControlOptions& options, const RunDirectory& run,
                               ProgressDisplay& progress);

}  // namespace ariadne::experiments
