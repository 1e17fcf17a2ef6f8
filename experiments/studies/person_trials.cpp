#include "experiments/studies/person_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/fittings.h"
#include "experiments/metrics/statistics.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/studies/person_contact.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

using drivers::Body;
using Eigen::Vector2d;
using slam::Pose2;

constexpr double kHallLength = 12.0, kHallWidth = 6.0, kWallDistance = 0.6;  // [m]
constexpr double kStartX = 1.5;                                              // [m]
constexpr double kAtGoal = 0.1;                                              // [m]
constexpr double kPause = 2.0, kLongest = 300.0;                             // [s]

/// A mesh of all the parts of a person.
Body PersonBody(const std::string& name, double height) {
  Body body{name, {}, {0.4}, {}};
  for (const drivers::Part& part : Make(drivers::Person{height, 0.3}))
    slam::Append(body.mesh_body, part.mesh);
  return body;
}

/// Walks from one side of the hall to the other, and may stop where it crosses the way.
void Walk(Body& body, double crossing, double crossing_time, double stop, const CrossingOptions& options,
          RandomStream& stream) {
  const double side = DrawUniform(stream, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  const double slant = DrawUniform(stream, -2.0, 2.0);  // [m]
  const double speed = DrawUniform(stream, options.slowest, options.fastest);
  const double half = 0.5 * kHallWidth - kWallDistance;
  const Vector2d middle(crossing, 0.5 * kHallWidth), across(slant, side * half);
  const double heading = std::atan2(across.y(), across.x()), leg = across.norm() / speed;
  const auto at = [&](double time, const Vector2d& p_map) {
    body.motion.times.push_back(time);
    body.motion.T_map_body.push_back(slam::ToPose3({heading, p_map}));
  };
  at(crossing_time - leg, middle - across);
  at(crossing_time, middle);
  if (stop > 0.0) at(crossing_time + stop, middle);
  at(crossing_time + stop + leg, middle + across);
}

planning::FreeSpace HallSpace() {
  const slam::Polygon2 hall{{{0.0, 0.0}, {kHallLength, 0.0}, {kHallLength, kHallWidth}, {0.0, kHallWidth}},
                            {}};
  return planning::FreeSpace({&hall, 1}, {.resolution = 0.05});
}

}  // namespace

drivers::World HallWithPersons(const CrossingOptions& options, double speed, std::uint64_t seed) {
  drivers::World world;
  world.name = "hall with persons";
  world.T_map_start = {0.0, {kStartX, 0.5 * kHallWidth}};
  const slam::Box3 hall(Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(kHallLength, kHallWidth, 3.0));
  world.bodies.push_back({"hall", drivers::MakeBox(hall), {}, {}});
  RandomStream stream = NamedStream(seed, "persons");
  for (int i = 0; i < options.persons; ++i) {
    const double way = DrawUniform(stream, 1.0, options.distance);
    const double late = DrawUniform(stream, -1.5, 2.5);  // after the robot would be there [s]
    const double stop = DrawUniform(stream, 0.0, options.longest_stop);
    const double height = DrawUniform(stream, 1.5, 1.95);
    Body person = PersonBody(fmt::format("person {}", i + 1), height);
    Walk(person, kStartX + way, 1.0 + way / speed + late, i % 2 == 0 ? 0.0 : stop, options, stream);
    world.bodies.push_back(std::move(person));
  }
  return world;
}

PersonTrial DriveAmongPersons(const CrossingOptions& options, const MissionOptions& mission, bool avoid,
                              std::uint64_t seed) {
  const double speed = mission.drive.follow.limits.max_speed;
  const auto scene = std::make_shared<const drivers::RayScene>(HallWithPersons(options, speed, seed));
  drivers::SimulatedRobot robot(scene, MissionRobotOptions(), seed);
  const planning::FreeSpace space = HallSpace();
  const Pose2 T_map_goal{0.0, {kStartX + options.distance, 0.5 * kHallWidth}};
  DriveOptions drive = mission.drive;
  drive.avoid_obstacles = avoid;
  const slam::ScannerModel scanner = drivers::AisMounting(MissionRobotOptions().ais).scanner;
  PersonTrial trial;
  trial.way = avoid ? "looks where it goes" : "does not look";
  for (int i = 0; i < options.attempts && !trial.reached && robot.Now() < kLongest; ++i) {
    const Pose2 T_map_base = robot.T_map_base_true();
    const planning::PathResult path = PlanPath(space, T_map_base, T_map_goal, mission.path, seed);
    if (path.status != planning::PathStatus::kFound) break;
    const Localizer localizer(robot, T_map_base, nullptr, scanner, mission.drive.localize);
    const DriveTask task{path.poses, {}, {}, {}, mission.path.footprint.margin};
    const DriveReport report = DrivePath(robot, localizer, task, drive, {});
    trial.given_up += report.end == DriveEnd::kBlocked ? 1 : 0;
    trial.reached = (robot.T_map_base_true().translation - T_map_goal.translation).norm() < kAtGoal;
    if (!trial.reached) robot.WaitUntil(robot.Now() + kPause);
  }
  trial.duration = robot.Now();
  for (const drivers::Collision& contact : robot.collisions()) {
    const ContactVerdict verdict =
        JudgeContact(contact, robot.path_true(), *scene, MissionRobotOptions(), drive);
    ++trial.contacts;
    trial.needless += verdict.needless ? 1 : 0;
    trial.foreseeable += verdict.foreseeable ? 1 : 0;
  }
  return trial;
}

Table PersonTable(const std::vector<PersonTrial>& trials) {
  Table table{{"robot", "episodes", "reached %", "contacts", "needless", "foreseeable", "given up",
               "time s", "95 % s"},
              {}};
  std::vector<std::string> ways;
  for (const PersonTrial& trial : trials) {
    if (std::ranges::find(ways, trial.way) == ways.end()) ways.push_back(trial.way);
  }
  for (const std::string& way : ways) {
    std::vector<double> times;
    int reached = 0, contacts = 0, needless = 0, foreseeable = 0, given_up = 0;
    for (const PersonTrial& trial : trials) {
      if (trial.way != way) continue;
      times.push_back(trial.duration);
      reached += trial.reached ? 1 : 0;
      contacts += trial.contacts, needless += trial.needless, foreseeable += trial.foreseeable;
      given_up += trial.given_up;
    }
    const auto count = static_cast<double>(times.size());
    table.rows.push_back({way, fmt::format("{}", times.size()),
                          fmt::format("{:.1f}", 100.0 * reached / count), fmt::format("{}", contacts),
                          fmt::format("{}", needless), fmt::format("{}", foreseeable),
                          fmt::format("{}", given_up), fmt::format("{:.1f}", Quantile(times, 0.5)),
                          fmt::format("{:.1f}", Quantile(times, 0.95))});
  }
  return table;
}

Table PersonTrialTable(const std::vector<PersonTrial>& trials) {
  Table table{{"robot", "reached", "contacts", "needless", "foreseeable", "given_up", "duration_s"}, {}};
  for (const PersonTrial& trial : trials) {
    table.rows.push_back({trial.way, trial.reached ? "1" : "0", fmt::format("{}", trial.contacts),
                          fmt::format("{}", trial.needless), fmt::format("{}", trial.foreseeable),
                          fmt::format("{}", trial.given_up), Exact(trial.duration)});
  }
  return table;
}

}  // namespace ariadne::experiments
