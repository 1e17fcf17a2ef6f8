#include "control/pure_pursuit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "control/path_leg.h"
#include "control/turn_in_place.h"
#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr double kSearched = 0.5;  // of the path ahead for the place nearest to the robot [m]

/// Of the circle through a pose's place, along its angle, and another place [1/m].
double CurvatureTo(const Pose2& pose, const Eigen::Vector2d& p) {
  const Eigen::Vector2d seen = pose.Inverse() * p;
  return 2.0 * seen.y() / std::max(seen.squaredNorm(), 1e-9);
}

/// How fast the path ahead may be driven, so that no curve, no change of curvature and no end comes too
/// suddenly [m/s].
double SpeedAhead(const DrivenLeg& leg, double passed, const FollowOptions& options) {
  const DriveLimits& limits = options.limits;
  const double braking = options.braking * limits.acceleration;
  const double rest = leg.length() - passed;
  const double horizon = std::min(rest, 0.5 * limits.max_speed * limits.max_speed / braking);
  double fastest = std::min(limits.max_speed, BrakingSpeed(rest, braking, options.period));
  const double step = 0.5 * options.lookahead;
  const auto curvature_at = [&](double way) {
    return CurvatureTo(leg.MotionAt(way), leg.MotionAt(way + options.lookahead).translation);
  };
  double before = curvature_at(passed);
  for (double ahead = 0.0; ahead <= horizon; ahead += step) {
    const double curvature = curvature_at(passed + ahead + step);
    const double change = std::abs(curvature - before) / step;
    const double largest = std::max(std::abs(curvature), std::abs(before));
    before = curvature;
    // Turning follows v c, at v^2 dc/ds.
    const double there =
        std::min(limits.max_turning / std::max(largest, 1e-9),
                 std::sqrt(options.braking * limits.turning_acceleration / std::max(change, 1e-9)));
    fastest = std::min(fastest, std::sqrt(there * there + 2.0 * braking * ahead));
  }
  return fastest;
}

/// One step on one path.
class Follower {
 public:
  Follower(const std::vector<Pose2>& path, const Pose2& T_map_robot, const PathProgress& progress,
           const FollowOptions& options)
      : path_(path), T_map_robot_(T_map_robot), options_(options), progress_(progress) {}

  FollowStep Next() {
    // Legs that are done, or too short to be driven, are passed.
    std::optional<DriveCommand> command;
    while (!command && progress_.leg + 1 < path_.size()) {
      const PathLeg leg = LegFrom(path_, progress_.leg, slam::RadFromDeg(options_.corner));
      command = leg.kind == LegKind::kTurn ? Turned(leg) : Driven(leg);
      if (!command) progress_ = {leg.last, 0.0, false, progress_.command};
    }
    if (!command) command = TurnBy(slam::WrapAngle(path_.back().angle - T_map_robot_.angle));
    const bool finished = !command;
    progress_.command = command.value_or(DriveCommand{});
    return {progress_.command, progress_, finished};
  }

 private:
  /// None where it has turned, and stands.
  std::optional<DriveCommand> TurnBy(double rest) const {
    const double tolerance = slam::RadFromDeg(options_.goal_angle);
    if (HasTurned(rest, tolerance, progress_.command, options_.period, options_.limits)) return {};
    return TurnInPlace(rest, progress_.command, options_.period, options_.limits);
  }

  std::optional<DriveCommand> Turned(const PathLeg& leg) {
    // Counted from where the path's turn begins, since it may be more than half a turn.
    const double ahead = slam::WrapAngle(T_map_robot_.angle - path_[leg.first].angle - progress_.passed);
    const double turned = progress_.passed + ahead;
    if ((turned > progress_.passed) == (leg.length > 0.0)) progress_.passed = turned;
    return TurnBy(leg.length - turned);
  }

  std::optional<DriveCommand> Driven(const PathLeg& leg) {
    const DrivenLeg driven(path_, leg);
    const bool backward = leg.kind == LegKind::kBackward;
    const Pose2 motion{slam::WrapAngle(T_map_robot_.angle + (backward ? std::numbers::pi : 0.0)),
                       T_map_robot_.translation};
    progress_.passed =
        driven.NearestWay(motion.translation, progress_.passed, progress_.passed + kSearched);
    if (driven.length() - progress_.passed <= options_.end_distance) return Stopped();
    const double speed_now = std::abs(progress_.command.forward);
    const double lookahead = std::max(options_.lookahead, options_.lookahead_time * speed_now);
    const Eigen::Vector2d aim = driven.MotionAt(progress_.passed + lookahead).translation;
    const Eigen::Vector2d seen = motion.Inverse() * aim;
    const double bearing = std::atan2(seen.y(), seen.x());
    if (std::abs(bearing) > slam::RadFromDeg(options_.turn_first)) progress_.turning = true;
    if (progress_.turning) {
      if (const auto turn = TurnBy(bearing)) return turn;
      progress_.turning = false;
    }
    const double speed = SpeedAhead(driven, progress_.passed, options_);
    const DriveCommand wanted{backward ? -speed : speed, speed * CurvatureTo(motion, aim)};
    return Limited(wanted, progress_.command, options_.period, options_.limits);
  }

  /// None where it stands.
  std::optional<DriveCommand> Stopped() const {
    const DriveCommand& before = progress_.command;
    if (before.forward == 0.0 && before.turning == 0.0) return {};
    return Limited({}, before, options_.period, options_.limits);
  }

  const std::vector<Pose2>& path_;
  const Pose2& T_map_robot_;
  const FollowOptions& options_;
  PathProgress progress_;
};

bool IsFinite(const Pose2& pose) { return std::isfinite(pose.angle) && pose.translation.allFinite(); }

}  // namespace

FollowStep FollowPath(const std::vector<Pose2>& path, const Pose2& T_map_robot,
                      const PathProgress& progress, const FollowOptions& options) {
  CheckOptions(options, "follow.");
  if (path.empty()) Fail("a path without a pose cannot be followed");
  if (progress.leg >= path.size())
    Fail("the progress is at pose {} of a path that has {}", progress.leg, path.size());
  if (!IsFinite(T_map_robot) || !std::ranges::all_of(path, IsFinite))
    Fail("a pose of the path, or the robot's, is not finite, and cannot be followed");
  return Follower(path, T_map_robot, progress, options).Next();
}

ApproachResult SimulateFollowing(const std::vector<Pose2>& path, const Pose2& T_map_robot,
                                 const FollowOptions& options) {
  ApproachResult result;
  Pose2 pose = T_map_robot;
  PathProgress progress;
  for (int periods = 0;; ++periods) {
    result.duration = periods * options.period;
    const FollowStep step = FollowPath(path, pose, progress, options);
    const bool late = !step.finished && result.duration >= options.max_time;
    result.samples.push_back({result.duration, pose, late ? DriveCommand{} : step.command});
    result.status = late ? ApproachStatus::kTimeOut : ApproachStatus::kReached;
    if (late || step.finished) return result;
    const double way = step.command.forward * options.period;
    const double turn = step.command.turning * options.period;
    pose = pose * Pose2::Exp({way, 0.0, turn});
    result.length += std::abs(way);
    result.turned += std::abs(turn);
    progress = step.progress;
  }
}

}  // namespace ariadne::control
