#include "experiments/mission/beside_memory.h"

#include <algorithm>
#include <cmath>

#include "experiments/mission/contact.h"

namespace ariadne::experiments {
namespace {

constexpr double kNearRobot = 1.2;   // the diagonal and a margin may sweep 0.5 m [m]
constexpr double kSameHeight = 0.1;  // [m]

/// Whether a place was within the angles of a scanner, at its height, at the middle of its sweep.
bool LooksTo(const drivers::SafetySweep& sweep, const Eigen::Vector3d& p_base,
             const drivers::RobotState& now) {
  const slam::Pose3 T_base_laser = LaserAtBeam(sweep, sweep.sweep.ranges.size() / 2, now);
  const Eigen::Vector3d p_laser = T_base_laser.Inverse() * p_base;
  if (std::abs(p_laser.z()) > kSameHeight) return false;
  const double angle = std::atan2(p_laser.x(), -p_laser.y());  // as ScannerModel counts: 0 is to the right
  const double step = sweep.scanner.angle_step, first = sweep.scanner.first_angle;
  const double last = first + step * (static_cast<double>(sweep.sweep.ranges.size()) - 1.0);
  return angle >= first - step && angle <= last + step;  // what it sees at its edge is not kept twice
}

}  // namespace

std::vector<Eigen::Vector2d> BesideMemory::Update(std::span<const drivers::SafetySweep> sweeps,
                                                  const drivers::RobotState& now) {
  const slam::Pose3 T_odom_base = slam::ToPose3(now.odometry.T_odom_base),
                    T_base_odom = T_odom_base.Inverse();
  std::vector<Eigen::Vector2d> points_base;
  std::vector<Eigen::Vector3d> near_odom;
  const auto add = [&](const Eigen::Vector3d& p_base) {
    points_base.emplace_back(p_base.head<2>());
    if (p_base.head<2>().norm() < kNearRobot) near_odom.push_back(T_odom_base * p_base);
  };
  for (const drivers::SafetySweep& sweep : sweeps) std::ranges::for_each(PointsOf(sweep, now), add);
  for (const Eigen::Vector3d& p_odom : near_odom_) {
    const Eigen::Vector3d p_base = T_base_odom * p_odom;
    const auto looks = [&](const drivers::SafetySweep& sweep) { return LooksTo(sweep, p_base, now); };
    if (p_base.head<2>().norm() < kNearRobot && std::ranges::none_of(sweeps, looks)) add(p_base);
  }
  near_odom_ = std::move(near_odom);
  return points_base;
}

}  // namespace ariadne::experiments
