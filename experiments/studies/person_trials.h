#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/simulated/simulated_robot.h"
#include "experiments/mission/mission_options.h"
#include "experiments/report/table.h"

namespace ariadne::experiments {

/// How persons walk across the way of a robot. They do not look where they go.
struct CrossingOptions {
  int persons = 2;
  double slowest = 0.5;
  double fastest = 1.6;
  double longest_stop = 8.0;
  double distance = 6.0;
  int attempts = 5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("persons", self.persons, Unit(""), Range{0, 100}, "in one episode");
    visit("slowest", self.slowest, Unit("m/s"), Range{0.01, 10.0}, "of walking persons");
    visit("fastest", self.fastest, Unit("m/s"), Range{0.01, 10.0}, "of walking persons");
    visit("longest_stop", self.longest_stop, Unit("s"), Range{0.0, 1000.0},
          "in the robot's way, of every other person");
    visit("distance", self.distance, Unit("m"), Range{1.0, 100.0}, "from the robot's start to its goal");
    visit("attempts", self.attempts, Unit(""), Range{1, 100},
          "to get there: a drive that is given up is planned anew from where the robot stands");
  }
};

/// One episode.
struct PersonTrial {
  std::string way;        // of driving
  bool reached = false;   // the goal, by the truth
  int contacts = 0;       // the robot moved into a person
  int needless = 0;       // of these, such that a robot which had braked in time was not touched
  int foreseeable = 0;    // of the contacts, those before which it could have seen them come, and stood
  int given_up = 0;       // drives
  double duration = 0.0;  // [s]
};

/// A hall of 12 m x 6 m, and persons who cross the way from one end to the other, each about when the robot
/// comes by.
drivers::World HallWithPersons(const CrossingOptions& options, double speed, std::uint64_t seed);

/// Drives once through it; `avoid`: looks where it goes.
PersonTrial DriveAmongPersons(const CrossingOptions& options, const MissionOptions& mission, bool avoid,
                              std::uint64_t seed);

/// Per way of driving.
Table PersonTable(const std::vector<PersonTrial>& trials);
Table PersonTrialTable(const std::vector<PersonTrial>& trials);

}  // namespace ariadne::experiments
