#include "experiments/mission/drive_sight.h"

#include <algorithm>
#include <cmath>

#include "control/swept_rectangle.h"
#include "experiments/mission/contact.h"

namespace ariadne::experiments {
namespace {

constexpr double kWithin = -0.03;     // the robot: cells that are coarser than what occupies them [m]
constexpr double kSeenError = 0.015;  // of the scanners [m]
constexpr double kOffPath = 0.02;     // by the controller and the localization [m]
constexpr double kOfKnown = 0.3;      // from what the map knows: what is seen there stands [m]
constexpr double kLookAhead = 0.5;    // for what moves, beyond the time to stop [s]

}  // namespace

DriveSight::DriveSight(const DriveTask& task, const DriveOptions& options, const slam::Pose2& T_map_base)
    : task_(task), options_(options), avoid_(options.avoid), moving_(options.moving) {
  avoid_.robot.margin = std::min(avoid_.robot.margin, std::max(kSeenError, task.margin - kOffPath));
  known_margin_ = std::max(0.0, task.margin - kOffPath - avoid_.robot.margin);
  KeepInMind(T_map_base);
}

/// What the map knows, but for what the robot stands in already, and for what would stand where it has
/// been: there the map errs.
void DriveSight::KeepInMind(const slam::Pose2& T_map_base) {
  control::RectangleOptions bare = avoid_.robot;
  bare.margin = 0.0;
  std::vector<control::PlacedRectangle> been;
  const std::size_t retraced = std::min(task_.retraced, task_.path_map.size());  // it may be cut
  for (std::size_t i = 0; i < retraced; ++i) been.emplace_back(bare, task_.path_map[i]);
  const control::PlacedRectangle at_start(bare, T_map_base);
  const double close = avoid_.robot.margin + known_margin_;
  for (const Eigen::Vector2d& p_map : task_.obstacles_map) {
    const bool stood = at_start.GapTo(p_map) <= kWithin;
    if (!stood &&
        std::ranges::none_of(been, [&](const auto& robot) { return robot.GapTo(p_map) <= close; }))
      known_map_.push_back(p_map);
  }
}

/// A place that errs by the known margin, as near ahead and beside as it may be.
Eigen::Vector2d DriveSight::Nearer(const Eigen::Vector2d& p_base) const {
  const Eigen::Array2d half(0.5 * avoid_.robot.length, 0.5 * avoid_.robot.width);
  const Eigen::Array2d from_centre = p_base - Eigen::Vector2d(avoid_.robot.centre_ahead, 0.0);
  const Eigen::Array2d nearer = (from_centre.abs() - half).max(0.0).min(known_margin_);
  return p_base - (from_centre.sign() * nearer).matrix();
}

/// Obstacles that the map knows, nearby in the robot's frame, but for those that it stands beside: cells
/// are coarse, and it must be able to leave.
std::vector<Eigen::Vector2d> DriveSight::KnownNearby(const slam::Pose2& T_map_base) const {
  std::vector<Eigen::Vector2d> points_base;
  const slam::Pose2 T_base_map = T_map_base.Inverse();
  const Eigen::Matrix2d R_base_map = T_base_map.RotationMatrix();
  for (const Eigen::Vector2d& p_map : known_map_) {
    if ((p_map - T_map_base.translation).norm() < options_.known_within)
      points_base.push_back(Nearer(R_base_map * p_map + T_base_map.translation));
  }
  return points_base;
}

/// Where what moves will be until the robot stands, if it brakes now; in its frame.
std::vector<Eigen::Vector2d> DriveSight::ToCome(std::span<const drivers::SafetySweep> sweeps,
                                                const drivers::RobotState& state,
                                                const slam::Pose2& T_map_base) {
  if (!options_.moving.watch) return {};
  const slam::Pose2 &T_odom_base = state.odometry.T_odom_base, T_base_odom = T_odom_base.Inverse();
  std::vector<Eigen::Vector2d> points = PlacesOf(sweeps, state);
  for (Eigen::Vector2d& p : points) p = T_odom_base * p;
  moving_.Update(points, T_odom_base.translation, state.stamp);
  const double braking = std::max(std::abs(state.velocity.forward) / avoid_.limits.acceleration,
                                  std::abs(state.velocity.turning) / avoid_.limits.turning_acceleration);
  const slam::Pose2 T_map_odom = T_map_base * T_base_odom;
  const auto stands = [&](const Eigen::Vector2d& p_odom) {
    const Eigen::Vector2d p_map = T_map_odom * p_odom;
    return std::ranges::any_of(task_.obstacles_map, [&](const Eigen::Vector2d& known_map) {
      return (known_map - p_map).squaredNorm() < kOfKnown * kOfKnown;
    });
  };
  std::vector<Eigen::Vector2d> places = moving_.PlacesUntil(kLookAhead + avoid_.reaction + braking, stands);
  for (Eigen::Vector2d& p : places) p = T_base_odom * p;
  return places;
}

DriveSight::Places DriveSight::Look(drivers::Robot& robot, const Localizer& localizer,
                                    const drivers::RobotState& state, bool known) {
  const std::vector<drivers::SafetySweep> sweeps = LookAround(robot, localizer.scanner());
  Places places{beside_.Update(sweeps, state), 0};
  places.seen = places.points_base.size();
  const auto add = [&](const std::vector<Eigen::Vector2d>& more_base) {
    places.points_base.insert(places.points_base.end(), more_base.begin(), more_base.end());
  };
  add(ToCome(sweeps, state, localizer.T_map_base()));
  if (known) add(KnownNearby(localizer.T_map_base()));
  return places;
}

}  // namespace ariadne::experiments
