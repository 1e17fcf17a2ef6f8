#include "control/avoidance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ariadne::control {
namespace {

using Eigen::Vector2d;
using slam::Pose2;

constexpr double kDeepest = 0.03;     // points within the rectangle are taken for errors of its edge [m]
constexpr double kTolerance = 0.001;  // [m]
constexpr double kArcAtOnce = 1.0;    // of turning [rad]
constexpr int kScaleBisections = 6;
constexpr int kPushSamples = 16;  // of the way ahead

Pose2 MovedBy(const DriveCommand& command, double time) {
  return Pose2::Exp({command.forward * time, 0.0, command.turning * time});
}

/// Of the corner that moves fastest [m/s].
double CornerSpeed(const RectangleOptions& robot, const DriveCommand& command) {
  constexpr double kMoment = 1e-3;  // [s]
  return 2.0 * HalfSweep(robot, {}, MovedBy(command, kMoment)) / kMoment;
}

/// The points that the robot can come near.
std::vector<Vector2d> PointsWithin(const std::vector<Vector2d>& points_base, double distance,
                                   const RectangleOptions& robot) {
  const PlacedRectangle here(robot, {});
  std::vector<Vector2d> near;
  for (const Vector2d& p : points_base) {
    if (here.GapTo(p) <= distance) near.push_back(p);
  }
  return near;
}

/// With no more margin than there is.
RectangleOptions Fitted(RectangleOptions robot, const std::vector<Vector2d>& points) {
  robot.tolerance = std::min(robot.tolerance, kTolerance);
  const PlacedRectangle here(robot, {});
  double clear = std::numeric_limits<double>::infinity();
  for (const Vector2d& p : points) clear = std::min(clear, robot.margin + here.GapTo(p));
  robot.margin = std::clamp(clear - robot.tolerance, -kDeepest, robot.margin);
  return robot;
}

/// How the robot stops if it takes up a command now: poses, T_base_robot.
std::vector<Pose2> StoppingPoses(const DriveCommand& command, const DriveCommand& velocity,
                                 const AvoidanceOptions& options) {
  std::vector<Pose2> poses{{}, MovedBy(velocity, options.reaction)};
  DriveCommand now = Limited(command, velocity, options.period, options.limits);
  constexpr int kMost = 10000;  // brakes that hardly work
  for (int i = 0; i < kMost && (now.forward != 0.0 || now.turning != 0.0); ++i) {
    poses.push_back(poses.back() * MovedBy(now, options.period));
    now = Limited({}, now, options.period, options.limits);
  }
  return poses;
}

/// The point that a command hits although the brakes are put on.
std::optional<Vector2d> HitWhileStopping(const DriveCommand& command, const DriveCommand& velocity,
                                         const std::vector<Vector2d>& points,
                                         const AvoidanceOptions& options) {
  const std::vector<Pose2> poses = StoppingPoses(command, velocity, options);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    if (const auto touch = FirstTouch(options.robot, poses[k - 1], poses[k], points))
      return points[touch->point];
  }
  return {};
}

struct ClearWay {
  double way = std::numeric_limits<double>::infinity();  // of the fastest corner [m]
  std::optional<Vector2d> p_base;
};

/// Along the curve of a command whose fastest corner moves at `speed`, as far as `distance` [m].
ClearWay ClearWayOf(const DriveCommand& command, double speed, double distance,
                    const std::vector<Vector2d>& points, const RectangleOptions& robot) {
  const double time = distance / speed;
  const int arcs = std::max(1, static_cast<int>(std::ceil(std::abs(command.turning) * time / kArcAtOnce)));
  for (int k = 0; k < arcs; ++k) {
    const Pose2 from = MovedBy(command, time * k / arcs), to = MovedBy(command, time * (k + 1) / arcs);
    if (const auto touch = FirstTouch(robot, from, to, points))
      return {distance * (k + touch->share) / arcs, points[touch->point]};
  }
  return {};
}

/// How the points push, that are within or beside what the rectangle sweeps ahead.
struct Push {
  double from_left = 0.0, from_right = 0.0;  // 0 to 1
};

Push PushOf(const DriveCommand& wanted, double speed, const std::vector<Vector2d>& points,
            const AvoidanceOptions& options) {
  const double sense = wanted.forward < 0.0 ? -1.0 : 1.0;  // backward, the world turned by half a turn
  const PlacedRectangle here(options.robot, {});
  Push push;
  for (int k = 0; k < kPushSamples; ++k) {
    const double share = static_cast<double>(k) / kPushSamples;
    const Pose2 T_robot_base = MovedBy(wanted, share * options.repulsion_ahead / speed).Inverse();
    const Eigen::Matrix2d R_robot_base = T_robot_base.RotationMatrix();
    for (const Vector2d& p_base : points) {
      const Vector2d p_robot = R_robot_base * p_base + T_robot_base.translation;
      const double gap = std::max(0.0, here.GapTo(p_robot));
      if (gap >= options.repulsion_beside) continue;
      const Vector2d p = sense * p_robot;
      if (p.x() <= 0.0) continue;
      const double nearness = (1.0 - share) * (1.0 - gap / options.repulsion_beside);
      const double strength = nearness * nearness;
      if (p.y() >= 0.0) push.from_left = std::max(push.from_left, strength);
      if (p.y() <= 0.0) push.from_right = std::max(push.from_right, strength);
    }
  }
  return push;
}

/// What is in the way on the left turns to the right, and the other way round [rad/s]. What pushes most on
/// each side counts, whatever the density of the points.
double Repulsion(const DriveCommand& wanted, const std::vector<Vector2d>& points,
                 const AvoidanceOptions& options) {
  if (wanted.forward == 0.0) return 0.0;
  const Push push = PushOf(wanted, CornerSpeed(options.robot, wanted), points, options);
  return options.repulsion * (push.from_right - push.from_left) * std::abs(wanted.forward) /
         options.limits.max_speed;
}

struct Slowed {
  double scale = 1.0;
  std::optional<Vector2d> p_base;
};

DriveCommand Scaled(const DriveCommand& command, double scale) {
  return {scale * command.forward, scale * command.turning};
}

/// How much of a command is possible.
Slowed SlowDown(const DriveCommand& command, const DriveCommand& velocity,
                const std::vector<Vector2d>& points, const AvoidanceOptions& options) {
  Slowed slowed;
  const double speed = CornerSpeed(options.robot, command);
  if (speed > 0.0) {
    const ClearWay clear = ClearWayOf(command, speed, options.slow_distance, points, options.robot);
    const double allowed = options.limits.max_speed * clear.way / options.slow_distance;
    if (allowed < speed) slowed = {allowed / speed, clear.p_base};
  }
  auto hit = HitWhileStopping(Scaled(command, slowed.scale), velocity, points, options);
  if (!hit) return slowed;
  double low = 0.0, high = slowed.scale;
  for (int i = 0; i < kScaleBisections; ++i) {
    const double middle = 0.5 * (low + high);
    const auto hit_there = HitWhileStopping(Scaled(command, middle), velocity, points, options);
    (hit_there ? high : low) = middle;
    if (hit_there) hit = hit_there;
  }
  return {low, hit};
}

/// As far as the robot gets in the reaction and while it stops, or is to slow down [m].
double Reach(const DriveCommand& wanted, const DriveCommand& velocity, const AvoidanceOptions& options) {
  double reach = std::max(options.slow_distance, options.repulsion_ahead + options.repulsion_beside);
  const std::vector<Pose2> poses = StoppingPoses(wanted, velocity, options);
  double moved = 0.0;
  for (std::size_t k = 1; k < poses.size(); ++k)
    moved += 2.0 * HalfSweep(options.robot, poses[k - 1], poses[k]);
  return std::max(reach, 2.0 * moved);  // twice: turning away may sweep more
}

}  // namespace

AvoidanceResult Avoid(const DriveCommand& wanted, const DriveCommand& velocity,
                      const std::vector<Vector2d>& points_base, const AvoidanceOptions& options) {
  CheckOptions(options, "avoidance.");
  if (!std::ranges::all_of(points_base, [](const Vector2d& p) { return p.allFinite(); }))
    Fail("a point that is to be avoided is not finite");
  const std::vector<Vector2d> points =
      PointsWithin(points_base, Reach(wanted, velocity, options), options.robot);
  if (points.empty()) return {wanted, false, {}};
  AvoidanceOptions fitted = options;
  fitted.robot = Fitted(options.robot, points);
  DriveCommand command = wanted;
  Slowed slowed = SlowDown(wanted, velocity, points, fitted);
  const double away = Repulsion(wanted, points, fitted);
  if (away != 0.0) {
    const DriveCommand aside = Saturated({wanted.forward, wanted.turning + away}, options.limits);
    const Slowed slowed_aside = SlowDown(aside, velocity, points, fitted);
    if (slowed_aside.scale >= slowed.scale) command = aside, slowed = slowed_aside;  // not into something
  }
  const double speed = slowed.scale * CornerSpeed(fitted.robot, command);
  if (slowed.scale < 1.0 && speed < options.creep) return {{}, true, slowed.p_base};
  return {Scaled(command, slowed.scale), false, slowed.p_base};
}

}  // namespace ariadne::control
