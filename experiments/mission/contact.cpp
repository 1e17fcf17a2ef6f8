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

std::vector<Eigen::Vector2d> PointsOf(std::span<const drivers::SafetySweep> sweeps) {
  std::vector<Eigen::Vector2d> points_base;
  for (const drivers::SafetySweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.sweep.ranges.size(); ++i) {
      const double range = sweep.sweep.ranges[i];
      if (!(range > 0.0)) continue;
      const Eigen::Vector3d beam = slam::BeamDirection(sweep.scanner, i, sweep.sweep.pitch);
      points_base.emplace_back((sweep.T_base_laser * (range * beam)).head<2>());
    }
  }
  return points_base;
}

Eigen::Vector2d ContactPlace(drivers::Robot& robot, const control::DriveCommand& command) {
  Eigen::Vector2d contact = SideThatMoved(command);
  double nearest = kNear;
  for (const Eigen::Vector2d& p_base : PointsOf(robot.TakeSafetySweeps())) {
    if (FromOutline(p_base) >= nearest) continue;
    nearest = FromOutline(p_base);
    contact = p_base;
  }
  return contact;
}

}  // namespace ariadne::experiments
