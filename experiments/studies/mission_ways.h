#pragma once

#include <string>
#include <vector>

#include "drivers/simulated/simulated_robot.h"
#include "experiments/mission/mission_options.h"
#include "experiments/studies/explored_robot.h"

namespace ariadne::experiments {

/// What is done otherwise than the configured mission does it, one thing at a time.
struct MissionVariantOptions {
  bool paper = true;
  int paper_scans = 60;
  std::string matching;
  std::string planners;
  std::string overlaps;
  std::string slices;
  std::string drives;
  std::string noises;
  std::string robots;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "paper", self.paper,
        "the configuration of 2003: the queue with points of slices, the printed constants of the planner, "
        "the controller with its fallbacks, odometry alone while driving");
    visit("paper_scans", self.paper_scans, Unit(""), Range{1, 100000},
          "after which missions with the paper's planner end, where mission.limits.max_scans does not end "
          "them before: it hardly leaves its neighbourhood, where something small is always left to see");
    visit("matching", self.matching, "methods of registration: a, b, ...; empty: none");
    visit(
        "planners", self.planners,
        "`paper`, the constants and the rule of the paper with the robot's clearances, or policies: a, b, "
        "...");
    visit("overlaps", self.overlaps, "least overlaps with what is known: a, b, ...");
    visit("slices", self.slices, "heights [m] in which the view is planned: a b c, d e f, ...");
    visit("drives", self.drives,
          "`approach`, the paper's controller and fallbacks; `approach_first`; `odometry`, without looking "
          "around while driving: a, b, ...");
    visit("noises", self.noises, "factors of the errors of the wheels: a, b, ...");
    visit("robots", self.robots,
          "`emulated`, the drivers of the real robot on emulated devices; `without_safety`, the simulated "
          "robot without safety scanners, which the emulated one has not either: a, b, ...");
  }
};

/// A mission to compare, and its robot.
struct MissionVariant {
  std::string name;
  MissionOptions mission;
  ExploringRobotOptions robot;
};

/// The mission as it is configured, `default`, and after it the variants. Error where a list cannot be
/// read.
std::vector<MissionVariant> MissionVariants(const MissionOptions& mission,
                                            const drivers::SimulatedRobotOptions& robot,
                                            const MissionVariantOptions& variants);

/// The names in a list: a, b, ...
std::vector<std::string> ListedNames(const std::string& text);

}  // namespace ariadne::experiments
