#include "experiments/mission/drive_path.h"

#include <cmath>

#include "experiments/mission/contact.h"

namespace ariadne::experiments {
namespace {

constexpr double kSlow = 0.1;         // when backing off [m/s]
constexpr double kSlowTurning = 0.2;  // [rad/s]
constexpr double kBackOffTime = 6.0;  // [s]
constexpr double kBackTurn = 0.35;    // [rad]

/// A drive under way.
class PathDrive {
 public:
  PathDrive(drivers::Robot& robot, const slam::Pose2& T_map_odom, const DriveOptions& options,
            const std::function<bool()>& stop)
      : robot_(robot), T_map_odom_(T_map_odom), options_(options), stop_(stop) {
    last_ = T_map_base();
  }

  DriveReport Along(const std::vector<slam::Pose2>& path_map);

 private:
  slam::Pose2 T_map_base() const { return T_map_odom_ * robot_.State().odometry.T_odom_base; }
  void Go(const control::DriveCommand& command);
  void Halt();
  DriveReport Ended(DriveEnd end);
  void BackOff(const control::DriveCommand& touching);

  drivers::Robot& robot_;
  slam::Pose2 T_map_odom_;
  const DriveOptions& options_;
  const std::function<bool()>& stop_;
  slam::Pose2 last_;
  DriveReport report_;
};

void PathDrive::Go(const control::DriveCommand& command) {
  robot_.Drive({command.forward, command.turning});
  robot_.WaitUntil(robot_.Now() + options_.follow.period);
  const slam::Pose2 now = T_map_base();
  report_.length += (now.translation - last_.translation).norm();
  last_ = now;
  report_.poses_map.push_back(now);
}

void PathDrive::Halt() {
  const double deadline = robot_.Now() + kBackOffTime;
  for (;;) {
    Go({});
    const drivers::Velocity velocity = robot_.State().velocity;
    if (std::abs(velocity.forward) + std::abs(velocity.turning) < 1e-6 || robot_.Now() > deadline) return;
  }
}

DriveReport PathDrive::Ended(DriveEnd end) {
  Halt();
  report_.end = end;
  return report_;
}

/// Away from what the robot touches, by undoing the motion in which it touched it.
void PathDrive::BackOff(const control::DriveCommand& touching) {
  const slam::Pose2 from = T_map_base();
  const double deadline = robot_.Now() + kBackOffTime;
  const double forward = touching.forward == 0.0 ? 0.0 : -std::copysign(kSlow, touching.forward);
  const double turning = touching.turning == 0.0 ? 0.0 : -std::copysign(kSlowTurning, touching.turning);
  bool cleared = false;
  while (robot_.Now() < deadline) {
    const slam::Pose2 moved = from.Inverse() * T_map_base();
    if (moved.translation.norm() > options_.back_off || std::abs(moved.angle) > kBackTurn) break;
    if (forward == 0.0) {
      Go({0.0, turning});
    } else {
      Go({forward, 0.0});
    }
    const bool blocked = robot_.State().blocked;
    if (cleared && blocked) break;  // at something else
    cleared = cleared || !blocked;
  }
  Halt();
}

DriveReport PathDrive::Along(const std::vector<slam::Pose2>& path_map) {
  const double deadline = robot_.Now() + options_.max_time;
  const bool held_at_start = robot_.State().blocked;  // stays so until the robot has moved
  const slam::Pose2 start = T_map_base();
  control::PathProgress progress;
  while (robot_.Now() < deadline) {
    if (stop_ && stop_()) return Ended(DriveEnd::kStopped);
    const slam::Pose2 now = T_map_base();
    const control::FollowStep step = control::FollowPath(path_map, now, progress, options_.follow);
    progress = step.progress;
    if (step.finished) return Ended(DriveEnd::kArrived);
    Go(step.command);
    const slam::Pose2 moved = start.Inverse() * now;
    const bool leaving = held_at_start && moved.translation.norm() < 0.1 && std::abs(moved.angle) < 0.2 &&
                         robot_.Now() < deadline - options_.max_time + kBackOffTime;
    if (!robot_.State().blocked || leaving) continue;
    Halt();
    report_.obstacles_map.push_back(now * ContactPlace(robot_, step.command));
    BackOff(step.command);
    break;
  }
  return Ended(DriveEnd::kBlocked);
}

}  // namespace

DriveReport DrivePath(drivers::Robot& robot, const slam::Pose2& T_map_odom,
                      const std::vector<slam::Pose2>& path_map, const DriveOptions& options,
                      const std::function<bool()>& stop) {
  return PathDrive(robot, T_map_odom, options, stop).Along(path_map);
}

}  // namespace ariadne::experiments
