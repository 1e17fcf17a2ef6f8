#include "drivers/simulated/tour.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::drivers {
namespace {

constexpr double kPeriod = 0.05;      // between commands [s]
constexpr double kArrived = 0.01;     // from a waypoint [m]
constexpr double kAligned = 0.005;    // with the direction to drive [rad]
constexpr double kTurningGain = 1.5;  // slower than the wheels accelerate, so that nothing overshoots [1/s]
constexpr double kForwardGain = 0.8;  // [1/s]
constexpr double kSlowestForward = 0.02;  // so that the robot arrives [m/s]
constexpr double kPatience = 120.0;       // for one leg [s]

double BearingTo(const slam::Pose2& T_map_base, const Eigen::Vector2d& goal_map) {
  const Eigen::Vector2d to_goal = goal_map - T_map_base.translation;
  return slam::WrapAngle(std::atan2(to_goal.y(), to_goal.x()) - T_map_base.angle);
}

[[noreturn]] void FailBlocked(const SimulatedBase& base, const Eigen::Vector2d& goal_map) {
  const Eigen::Vector2d& at = base.T_map_base_true().translation;
  Fail("the tour is blocked at ({:.2f}, {:.2f}) on the way to ({:.2f}, {:.2f}): move its waypoints", at.x(),
       at.y(), goal_map.x(), goal_map.y());
}

void TurnTo(SimulatedBase& base, double heading_map) {
  const double deadline = base.Now() + kPatience;
  while (true) {
    const double error = slam::WrapAngle(heading_map - base.T_map_base_true().angle);
    if (std::abs(error) < kAligned || base.Now() > deadline) break;
    base.Drive({0.0, kTurningGain * error});
    base.WaitUntil(base.Now() + kPeriod);
  }
  base.Halt();
}

void DriveTo(SimulatedBase& base, const Eigen::Vector2d& goal_map) {
  const Eigen::Vector2d start = base.T_map_base_true().translation;
  if ((goal_map - start).norm() < kArrived) return;
  const Eigen::Vector2d ahead = (goal_map - start).normalized();
  TurnTo(base, std::atan2(ahead.y(), ahead.x()));
  const double deadline = base.Now() + kPatience;
  while (true) {
    const slam::Pose2& T_map_base = base.T_map_base_true();
    const double distance = ahead.dot(goal_map - T_map_base.translation);
    if (distance < kArrived) break;
    if (!base.collisions().empty() || base.Now() > deadline) FailBlocked(base, goal_map);
    const double bearing = distance > 0.2 ? BearingTo(T_map_base, goal_map) : 0.0;
    base.Drive({std::max(kSlowestForward, kForwardGain * distance), kTurningGain * bearing});
    base.WaitUntil(base.Now() + kPeriod);
  }
  base.Halt();
}

TourStop StopHere(SimulatedBase& base, double pause) {
  TourStop stop{base.Now(), base.T_map_base_true(), base.State().odometry};
  base.WaitUntil(base.Now() + pause);
  return stop;
}

}  // namespace

std::vector<Eigen::Vector2d> ParseWaypoints(const std::string& text, const std::string& where) {
  std::vector<Eigen::Vector2d> waypoints;
  std::istringstream points(text);
  for (std::string point; std::getline(points, point, ',');) {
    std::istringstream numbers(point);
    Eigen::Vector2d p;
    std::string rest;
    if (!(numbers >> p.x() >> p.y()) || numbers >> rest || !p.allFinite()) {
      Fail("{}: '{}' is not a point; write x y, x y, ... in metres", where, point);
    }
    waypoints.push_back(p);
  }
  if (waypoints.size() < 2) Fail("{}: a tour needs two points: x y, x y", where);
  return waypoints;
}

std::vector<Eigen::Vector2d> StopsOf(const Tour& tour) {
  std::vector<Eigen::Vector2d> stops{tour.waypoints_map.front()};
  double since_stop = 0.0;
  for (std::size_t i = 1; i < tour.waypoints_map.size(); ++i) {
    const Eigen::Vector2d from = tour.waypoints_map[i - 1];
    const Eigen::Vector2d leg = tour.waypoints_map[i] - from;
    double along = tour.spacing - since_stop;
    for (; along <= leg.norm() + 1e-9; along += tour.spacing)
      stops.push_back(from + along * leg.normalized());
    since_stop = leg.norm() - (along - tour.spacing);
  }
  if (stops.size() > tour.max_stops) stops.resize(tour.max_stops);
  return stops;
}

slam::Pose2 StartOf(const Tour& tour) {
  const Eigen::Vector2d ahead = tour.waypoints_map[1] - tour.waypoints_map[0];
  return {std::atan2(ahead.y(), ahead.x()), tour.waypoints_map[0]};
}

std::vector<TourStop> DriveTour(SimulatedBase& base, const Tour& tour, double pause) {
  const std::vector<Eigen::Vector2d> goals = StopsOf(tour);
  std::vector<TourStop> stops{StopHere(base, pause)};
  std::size_t next = 1;  // goal
  for (std::size_t i = 1; i < tour.waypoints_map.size() && next < goals.size(); ++i) {
    const Eigen::Vector2d& from = tour.waypoints_map[i - 1];
    const Eigen::Vector2d& to = tour.waypoints_map[i];
    const auto on_leg = [&](const Eigen::Vector2d& p) {
      return std::abs((p - from).norm() + (to - p).norm() - (to - from).norm()) < 1e-6;
    };
    for (; next < goals.size() && on_leg(goals[next]); ++next) {
      DriveTo(base, goals[next]);
      stops.push_back(StopHere(base, pause));
    }
    if (next < goals.size()) DriveTo(base, to);
  }
  return stops;
}

}  // namespace ariadne::drivers
