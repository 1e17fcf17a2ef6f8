#pragma once

#include <string>

#include "control/simulate_approach.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// Fig. 9: paths to the pose (0, 0, 0) from many others.
struct Fig09Options {
  control::ApproachOptions approach;
  int starts = 24;
  double radius = 5.0;
  double heading = 0.0;
  int width = 1400;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("approach", self.approach, "the controller; gains as in the paper");
    visit("starts", self.starts, Unit(""), Range{1, 1000}, "evenly on a circle around the goal");
    visit("radius", self.radius, Unit("m"), Range{0.1, 1000.0}, "of the circle");
    visit("heading", self.heading, Unit("deg"), Range{-180.0, 180.0},
          "of all starts; 0: as at the goal, which those beyond it have behind them");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the picture");
  }
};

/// Error where the controller's gains do not end its paths straight.
void CheckFig09(const Fig09Options& options);

/// Returns what to print.
std::string RunFig09(const Fig09Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
