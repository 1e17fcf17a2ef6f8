#pragma once

#include <string>

#include "control/simulate_approach.h"
#include "control/swept_rectangle.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// Fig. 8: the frames and the quantities of the control law, drawn to scale from one state.
struct Fig08Options {
  control::ApproachOptions approach;
  control::RectangleOptions robot;
  double x = -3.2;
  double y = -2.3;
  double heading = 12.0;
  int width = 1400;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("approach", self.approach, "the controller; gains as in the paper");
    visit("robot", self.robot, "its outline");
    visit("x", self.x, Unit("m"), Range{-100.0, 100.0}, "where the robot stands, in the frame of the goal");
    visit("y", self.y, Unit("m"), Range{-100.0, 100.0}, "and to the left of it");
    visit("heading", self.heading, Unit("deg"), Range{-180.0, 180.0},
          "phi, of the robot, against that at the goal");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the picture");
  }
};

/// Error where the controller's gains do not end its paths straight, or the robot stands on the goal.
void CheckFig08(const Fig08Options& options);

/// Returns what to print.
std::string RunFig08(const Fig08Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
