#include "experiments/exploration/robot_drive.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kPeriod = 0.05;      // between commands [s]
constexpr double kArrived = 0.01;     // at a place [m]
constexpr double kAligned = 0.005;    // with a heading [rad]
constexpr double kTurningGain = 1.5;  // slower than the wheels accelerate, so that nothing overshoots [1/s]
constexpr double kForwardGain = 0.8;  // [1/s]
constexpr double kSlowestForward = 0.02;  // so that the robot arrives [m/s]
constexpr double kSlow = 0.1;             // when clearing a contact [m/s]
constexpr double kBackBy = 0.2;           // [m]
constexpr double kCleared = 0.2;          // by turning so far [rad]
constexpr int kStrokes = 4;
constexpr double kPatience = 120.0;  // for one leg [s]
constexpr double kStuck = 5.0;       // after which a contact that does not clear counts anew [s]
constexpr double kNear = 0.1;        // a thing that touches the outline, as scanners measure it [m]
constexpr double kHalfLength = 0.4, kHalfWidth = 0.3;  // of the robot (Sec. 2.1) [m]
constexpr double kBeyond = 0.05;                       // the side that touches [m]

/// The robot, and where it takes itself to be while it drives.
struct DrivenRobot {
  drivers::Robot& robot;
  slam::Pose2 T_map_odom;

  slam::Pose2 T_map_base() const { return T_map_odom * robot.State().odometry.T_odom_base; }
  bool blocked() const { return robot.State().blocked; }
  void Go(double forward, double turning) const {
    robot.Drive({forward, turning});
    robot.WaitUntil(robot.Now() + kPeriod);
  }
  void Halt() const {
    robot.Drive({});
    while (std::abs(robot.State().velocity.forward) + std::abs(robot.State().velocity.turning) > 1e-6)
      robot.WaitUntil(robot.Now() + kPeriod);
  }
};

/// How far a place is from the robot's outline; negative inside.
double FromOutline(const Eigen::Vector2d& p_base) {
  const Eigen::Vector2d beyond = p_base.cwiseAbs() - Eigen::Vector2d(kHalfLength, kHalfWidth);
  const double inside = std::min(0.0, beyond.maxCoeff());
  return beyond.cwiseMax(0.0).norm() + inside;
}

/// What the safety scanners see at the outline; `guess` where they see nothing.
Eigen::Vector2d ContactPlace(drivers::Robot& robot, const Eigen::Vector2d& guess_base) {
  Eigen::Vector2d contact = guess_base;
  double nearest = kNear;
  for (const drivers::SafetySweep& sweep : robot.TakeSafetySweeps()) {
    for (std::size_t i = 0; i < sweep.sweep.ranges.size(); ++i) {
      const double range = sweep.sweep.ranges[i];
      if (!(range > 0.0)) continue;
      const Eigen::Vector2d p_base =
          (sweep.T_base_laser * (range * slam::BeamDirection(sweep.scanner, i, sweep.sweep.pitch)))
              .head<2>();
      if (FromOutline(p_base) >= nearest) continue;
      nearest = FromOutline(p_base);
      contact = p_base;
    }
  }
  return contact;
}

/// Goes on with a velocity until the robot has moved away, or is stopped once more.
template <typename Far>
void Retreat(const DrivenRobot& driven, double forward, double turning, const Far& far) {
  const slam::Pose2 from = driven.T_map_base();
  const double deadline = driven.robot.Now() + kPatience;
  bool cleared = false;
  while (!far(from.Inverse() * driven.T_map_base()) && driven.robot.Now() < deadline) {
    driven.Go(forward, turning);
    if (cleared && driven.blocked()) break;
    cleared = cleared || !driven.blocked();
    if (!cleared && driven.robot.Now() > deadline - kPatience + kStuck) break;
  }
  driven.Halt();
}

DriveOutcome StoppedAhead(const DrivenRobot& driven) {
  driven.Halt();
  const Eigen::Vector2d contact =
      driven.T_map_base() * ContactPlace(driven.robot, {kHalfLength + kBeyond, 0.0});
  Retreat(driven, -kSlow, 0.0, [](const slam::Pose2& moved) { return moved.translation.norm() > kBackBy; });
  return {true, contact};
}

/// One turn, until it is done or stopped. Where it is stopped, `contact_base` says by what.
struct TurnOutcome {
  bool done = false;
  Eigen::Vector2d contact_base = Eigen::Vector2d::Zero();
};

TurnOutcome TurnOnce(const DrivenRobot& driven, double heading_map) {
  const double deadline = driven.robot.Now() + kPatience;
  const bool was_blocked = driven.blocked();  // stays so until the robot has moved
  double turned = 0.0;
  while (driven.robot.Now() < deadline) {
    const slam::Pose2 before = driven.T_map_base();
    const double error = slam::WrapAngle(heading_map - before.angle);
    if (std::abs(error) < kAligned) break;
    driven.Go(0.0, kTurningGain * error);
    turned += std::abs(slam::WrapAngle(driven.T_map_base().angle - before.angle));
    const bool starting =
        was_blocked && turned < kCleared && driven.robot.Now() < deadline - kPatience + kStuck;
    if (!driven.blocked() || starting) continue;
    driven.Halt();
    const double side = error > 0.0 ? kHalfWidth + kBeyond : -kHalfWidth - kBeyond;
    return {false, ContactPlace(driven.robot, {kHalfLength, side})};
  }
  driven.Halt();
  return {true};
}

/// Turns, and moves off by a little what stops the turn: ahead if it is behind, back if it is ahead. Beside
/// a wall the robot so leaves it in a few strokes.
DriveOutcome TurnTowards(const DrivenRobot& driven, double heading_map) {
  for (int stroke = 0;; ++stroke) {
    const TurnOutcome turn = TurnOnce(driven, heading_map);
    if (turn.done) return {};
    const Eigen::Vector2d contact_map = driven.T_map_base() * turn.contact_base;
    const double forward = turn.contact_base.x() > 0.0 ? -kSlow : kSlow;
    Retreat(driven, forward, 0.0,
            [](const slam::Pose2& moved) { return moved.translation.norm() > kBackBy; });
    if (stroke == kStrokes) return {true, contact_map};
  }
}

DriveOutcome DriveStraight(const DrivenRobot& driven, const Eigen::Vector2d& goal_map,
                           const Eigen::Vector2d& ahead) {
  const double deadline = driven.robot.Now() + kPatience;
  const bool was_blocked = driven.blocked();
  double driven_by = 0.0;
  while (driven.robot.Now() < deadline) {
    const slam::Pose2 T_map_base = driven.T_map_base();
    const Eigen::Vector2d to_goal = goal_map - T_map_base.translation;
    const double distance = ahead.dot(to_goal);
    if (distance < kArrived) break;
    const double bearing = slam::WrapAngle(std::atan2(to_goal.y(), to_goal.x()) - T_map_base.angle);
    driven.Go(std::max(kSlowestForward, kForwardGain * distance),
              distance > 0.2 ? kTurningGain * bearing : 0.0);
    driven_by += (driven.T_map_base().translation - T_map_base.translation).norm();
    const bool starting =
        was_blocked && driven_by < kBackBy && driven.robot.Now() < deadline - kPatience + kStuck;
    if (driven.blocked() && !starting) return StoppedAhead(driven);
  }
  driven.Halt();
  return {};
}

DriveOutcome DriveTowards(const DrivenRobot& driven, const Eigen::Vector2d& goal_map) {
  for (int turn = 0; turn < 2; ++turn) {  // once more after strokes, which have moved the robot
    const Eigen::Vector2d ahead = goal_map - driven.T_map_base().translation;
    if (ahead.norm() < kArrived) return {};
    DriveOutcome turned = TurnTowards(driven, std::atan2(ahead.y(), ahead.x()));
    if (turned.blocked) return turned;
  }
  const Eigen::Vector2d ahead = (goal_map - driven.T_map_base().translation).normalized();
  return DriveStraight(driven, goal_map, ahead);
}

}  // namespace

DriveOutcome DriveWay(drivers::Robot& robot, const slam::Pose2& T_map_odom,
                      std::span<const Eigen::Vector2d> way_map, double heading_map) {
  const DrivenRobot driven{robot, T_map_odom};
  for (const Eigen::Vector2d& place : way_map) {
    DriveOutcome outcome = DriveTowards(driven, place);
    if (outcome.blocked) return outcome;
  }
  return TurnTowards(driven, heading_map);
}

}  // namespace ariadne::experiments
