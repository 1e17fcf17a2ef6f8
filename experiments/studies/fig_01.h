#pragma once

#include <string>

#include "drivers/simulated/simulated_robot.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// Fig. 1: the robot with its scanner, and the scanner, rendered from models with the dimensions that are
/// simulated.
struct Fig01Options {
  drivers::SimulatedRobotOptions robot;
  double pitch = 0.3;
  int width = 1100;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("robot", self.robot, "its dimensions, and where its scanners are");
    visit("pitch", self.pitch, Unit("rad"), Range{-1.58, 1.58}, "of the 3D scanner; positive looks up");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of each panel");
  }
};

/// Returns what to print.
std::string RunFig01(const Fig01Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
