#pragma once

#include <string>

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/person_trials.h"

namespace ariadne::experiments {

/// The experiment `walking_persons`: a robot drives through a hall in which persons cross its way (5.3), as
/// a mission lets it drive, and beside it one that does not look where it goes.
struct WalkingPersonsOptions {
  CrossingOptions crossing;
  MissionOptions mission;
  int episodes = 1000;
  int seed = 1;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("crossing", self.crossing, "how they walk");
    visit("mission", self.mission, "how the robot drives: its paths, and mission.drive");
    visit("episodes", self.episodes, Unit(""), Range{1, 1e6}, "of each robot, with the same persons");
    visit("seed", self.seed, Unit(""), Range{0, 1e9}, "of the persons and the robot's errors");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "the result does not depend on it");
  }
};

/// Error where persons walk slower than they walk at least.
void CheckWalkingPersons(const WalkingPersonsOptions& options);

/// Returns what to print.
std::string RunWalkingPersons(const WalkingPersonsOptions& options, const RunDirectory& run,
                              ProgressDisplay& progress);

}  // namespace ariadne::experiments
