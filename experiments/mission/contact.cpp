#include "experiments/mission/contact.h"

#include <algorithm>
#include <cmath>

namespace ariadne::experiments {
namespace {

constexpr double kNear = 0.1;                          // touches the outline, as scanners measure it [m]
constexpr double kHalfLength = 0.4, kHalfWidth = 0.3;  // of the robot (Sec. 2.1) [m]
constexpr double kBeyond = 0.05;                       // [m]

/// How far a place is from the robot's outline; negative inside.
double FromOutline(const Eigen::Vector2d& p_base) {
  const Eigen::Vector2d beyond = p_base.cwiseAbs() - Eigen::Vector2d(kHalfLength, kHalfWidth);
  const double inside = std::min(0.0, beyond.maxCoeff());
  return beyond.cwiseMax(0.0).norm() + inside;
}

Eigen::Vector2d SideThatMoved(const control::DriveCommand& command) {
  const double end = std::copysign(kHalfLength + kBeyond, command.forward);
  if (std::abs(command.forward) > 1e-6) return {end, 0.0};
  return {kHalfLength, std::copysign(kHalfWidth + kBeyond, command.turning)};
}

}  // namespace

slam::Pose3 LaserAtBeam(const drivers::SafetySweep& sweep, std::size_t beam,
                        const drivers::RobotState& now) {
  const double age = now.stamp - sweep.sweep.stamp - slam::BeamTime(sweep.scanner, beam);
  const slam::Pose2 T_now_then =
      slam::Pose2::Exp({-now.velocity.forward * age, 0.0, -now.velocity.turning * age});
  return slam::ToPose3(T_now_then) * sweep.T_base_laser;
}

std::vector<Eigen::Vector3d> PointsOf(const drivers::SafetySweep& sweep, const drivers::RobotState& now) {
  std::vector<Eigen::Vector3d> points_base;
  for (std::size_t i = 0; i < sweep.sweep.ranges.size(); ++i) {
    const double range = sweep.sweep.ranges[i];
    if (!(range > 0.0)) continue;
    const Eigen::Vector3d beam = slam::BeamDirection(sweep.scanner, i, sweep.sweep.pitch);
    points_base.push_back(LaserAtBeam(sweep, i, now) * (range * beam));
  }
  return points_base;
}

std::vector<Eigen::Vector2d> PlacesOf(std::span<const drivers::SafetySweep> sweeps,
                                      const drivers::RobotState& now) {
  std::vector<Eigen::Vector2d> places_base;
  for (const drivers::SafetySweep& sweep : sweeps) {
    for (const Eigen::Vector3d& p_base : PointsOf(sweep, now)) places_base.push_back(p_base.head<2>());
  }
  return places_base;
}

std::vector<drivers::SafetySweep> LookAround(drivers::Robot& robot, const slam::ScannerModel& scanner) {
  std::vector<drivers::SafetySweep> sweeps = robot.TakeSafetySweeps();
  sweeps.push_back({robot.T_base_laser(), scanner, robot.TakeSweep()});
  return sweeps;
}

Eigen::Vector2d ContactPlace(drivers::Robot& robot, const slam::ScannerModel& scanner,
                             const control::DriveCommand& command) {
  Eigen::Vector2d contact = SideThatMoved(command);
  double nearest = kNear;
  const drivers::RobotState now = robot.State();
  for (const Eigen::Vector2d& p_base : PlacesOf(LookAround(robot, scanner), now)) {
    if (FromOutline(p_base) >= nearest) continue;
    nearest = FromOutline(p_base);
    contact = p_base;
  }
  return contact;
}

}  // namespace ariadne::experiments
