#include "experiments/mission/drive_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/mission/contact.h"
#include "experiments/mission/drive_guide.h"
#include "experiments/mission/drive_sight.h"
#include "experiments/mission/way_back.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kSlow = 0.15;          // when backing off [m/s]
constexpr double kSlowTurning = 0.3;    // [rad/s]
constexpr double kHaltTime = 6.0;       // [s]
constexpr double kStartingTime = 6.0;   // a contact at the start has so long to clear [s]
constexpr double kHardly = 0.3;         // of the speed that is wanted, back
constexpr double kStraightBack = 0.05;  // at least, instead [m/s]
constexpr double kHardlyAhead = 0.03;   // [m/s]
constexpr double kLessAhead = 0.1;      // at most, instead [m/s]
constexpr double kAdvance = 0.08;       // [m]
constexpr double kAdvanceTurn = 0.12;   // [rad]
constexpr double kLeft = 0.06;          // [m]
constexpr double kLeftTurn = 0.1;       // [rad]
constexpr double kWriggleTime = 1.5;    // for one motion [s]
constexpr int kWriggles = 2;            // rounds

double TurnBetween(const slam::Pose2& a, const slam::Pose2& b) {
  return std::abs(slam::WrapAngle(a.angle - b.angle));
}

/// In a narrow place a robot turns less where the turn that is wanted is barred by what is beside it, or
/// all but barred: a circle through the path ahead swings its corners out a little farther than the path
/// does, and the next circles need less. Out of such a place it gets as straight as it came.
control::AvoidanceResult AvoidTurningLess(const control::DriveCommand& wanted,
                                          const control::DriveCommand& velocity,
                                          const std::vector<Eigen::Vector2d>& points_base,
                                          const control::AvoidanceOptions& options) {
  control::AvoidanceResult avoided = control::Avoid(wanted, velocity, points_base, options);
  if (wanted.forward == 0.0) return avoided;
  const bool back = wanted.forward < 0.0;
  const double hardly = back ? kHardly * -wanted.forward : kHardlyAhead;
  const double least =
      back ? std::max(-wanted.forward, kStraightBack) : std::min(wanted.forward, kLessAhead);
  for (const double share : {0.5, 0.0}) {
    if (std::abs(avoided.command.forward) >= hardly) break;
    control::AvoidanceResult less =
        control::Avoid({back ? -least : least, share * wanted.turning}, velocity, points_base, options);
    if (std::abs(less.command.forward) > std::abs(avoided.command.forward)) avoided = std::move(less);
  }
  return avoided;
}

/// A drive under way.
class PathDrive {
 public:
  PathDrive(drivers::Robot& robot, Localizer localizer, const DriveTask& task, const DriveOptions& options,
            const std::function<bool()>& stop)
      : robot_(robot),
        localizer_(std::move(localizer)),
        task_(task),
        options_(options),
        sight_(task, options, localizer_.T_map_base()),
        stop_(stop) {
    const slam::Pose2 start = localizer_.T_map_base();
    report_.poses_map.push_back(start);
    advanced_to_ = start;
    advanced_at_ = robot.Now();
  }

  DriveReport Run();

 private:
  void NoteAdvance();
  bool Stalls() const { return robot_.Now() - advanced_at_ > options_.patience; }
  bool MustStop() const { return stop_ && stop_(); }
  void Go(const control::DriveCommand& command);
  control::DriveCommand GoAvoiding(const control::DriveCommand& wanted, bool known);
  void Halt();
  std::string Reason(bool stalls) const;
  DriveReport Ended(DriveEnd end);
  void BackOff();
  void FollowBack(double start);
  void Wriggle();
  bool HasLeft(const slam::Pose2& place) const;

  drivers::Robot& robot_;
  Localizer localizer_;
  const DriveTask& task_;
  const DriveOptions& options_;
  DriveSight sight_;
  const std::function<bool()>& stop_;
  slam::Pose2 advanced_to_;
  double advanced_at_ = 0.0;                     // [s]
  double due_ = 0.0;                             // the next command: real robots take time to answer [s]
  std::optional<Eigen::Vector2d> held_by_base_;  // that the scanners see
  std::optional<Eigen::Vector2d> held_map_;      // that the scanners see, or the map knows
  DriveReport report_;
};

/// Returns what it did instead of what was wanted.
control::DriveCommand PathDrive::GoAvoiding(const control::DriveCommand& wanted, bool known) {
  control::DriveCommand command = wanted;
  held_by_base_.reset();
  held_map_.reset();
  if (options_.avoid_obstacles) {
    const drivers::RobotState state = robot_.State();
    const DriveSight::Places places = sight_.Look(robot_, localizer_, state, known);
    const control::AvoidanceResult avoided = AvoidTurningLess(
        wanted, {state.velocity.forward, state.velocity.turning}, places.points_base, sight_.avoid());
    command = avoided.command;
    if (avoided.p_base) held_map_ = localizer_.T_map_base() * *avoided.p_base;
    const std::span<const Eigen::Vector2d> seen(places.points_base.data(), places.seen);
    if (avoided.blocked && avoided.p_base && std::ranges::find(seen, *avoided.p_base) != seen.end())
      held_by_base_ = avoided.p_base;
  }
  NoteAdvance();
  Go(command);
  return command;
}

/// Noise lets a robot that is held up creep now and then; only a real advance counts.
void PathDrive::NoteAdvance() {
  const slam::Pose2& now = localizer_.T_map_base();
  const double way = (now.translation - advanced_to_.translation).norm();
  if (way < kAdvance && TurnBetween(now, advanced_to_) < kAdvanceTurn) return;
  advanced_to_ = now;
  advanced_at_ = robot_.Now();
}

void PathDrive::Go(const control::DriveCommand& command) {
  robot_.Drive({command.forward, command.turning});
  const double told = robot_.Now();
  if (told > due_ + options_.follow.period) due_ = told;  // the first one, or a robot that was slow
  due_ += options_.follow.period;
  robot_.WaitUntil(due_);
  const slam::Pose2 now = localizer_.Update();
  const slam::Pose2& before = report_.poses_map.back();
  report_.length += (now.translation - before.translation).norm();
  report_.poses_map.push_back(now);
}

void PathDrive::Halt() {
  const double deadline = robot_.Now() + kHaltTime;
  for (;;) {
    Go({});
    const drivers::Velocity velocity = robot_.State().velocity;
    if (std::abs(velocity.forward) + std::abs(velocity.turning) < 1e-6 || robot_.Now() > deadline) return;
  }
}

DriveReport PathDrive::Ended(DriveEnd end) {
  Halt();
  report_.end = end;
  report_.covariance = localizer_.covariance();
  return report_;
}

bool PathDrive::HasLeft(const slam::Pose2& place) const {
  const slam::Pose2& now = localizer_.T_map_base();
  return (now.translation - place.translation).norm() > kLeft || TurnBetween(now, place) > kLeftTurn;
}

/// Away from what holds the robot up: the way that it came. If it touches something, and that way is
/// barred, any that is not.
void PathDrive::BackOff() {
  const slam::Pose2 touching = localizer_.T_map_base();
  FollowBack(robot_.Now());
  if (robot_.State().blocked && !HasLeft(touching)) Wriggle();
  Halt();
}

void PathDrive::FollowBack(double start) {
  std::vector<slam::Pose2> driven(task_.trail_map.begin(), task_.trail_map.end());
  driven.insert(driven.end(), report_.poses_map.begin(), report_.poses_map.end());
  const std::vector<slam::Pose2> back = WayBack(driven, options_.back_off);
  control::FollowOptions slow = options_.follow;
  slow.limits.max_speed = kSlow;
  slow.limits.max_turning = kSlowTurning;
  control::PathProgress progress;
  advanced_at_ = start;
  bool cleared = false;
  while (robot_.Now() < start + options_.max_time && !MustStop()) {
    const control::FollowStep step = control::FollowPath(back, localizer_.T_map_base(), progress, slow);
    if (step.finished) break;
    progress = step.progress;
    progress.command = GoAvoiding(step.command, false);
    if (Stalls()) break;
    const bool blocked = robot_.State().blocked;
    if (cleared && blocked) break;  // at something else
    if (blocked && robot_.Now() > start + kStartingTime) break;
    cleared = cleared || !blocked;
  }
  Halt();
}

/// Tries small motions, ahead, back and round, of which the simplest that leads away is right.
void PathDrive::Wriggle() {
  const slam::Pose2 touching = localizer_.T_map_base();
  constexpr std::array<control::DriveCommand, 4> kMotions{
      {{-kSlow, 0.0}, {kSlow, 0.0}, {0.0, kSlowTurning}, {0.0, -kSlowTurning}}};
  for (int round = 0; round < kWriggles; ++round) {
    for (const control::DriveCommand& motion : kMotions) {
      const double end = robot_.Now() + kWriggleTime;
      const slam::Pose2 before = localizer_.T_map_base();
      while (robot_.Now() < end && !MustStop()) {
        Go(motion);
        if (robot_.State().blocked && !HasLeft(before) && robot_.Now() > end - 0.5 * kWriggleTime) break;
      }
      Halt();
      if (HasLeft(touching) && !robot_.State().blocked) return;
    }
  }
}

/// Why the drive is given up.
std::string PathDrive::Reason(bool stalls) const {
  const Eigen::Vector2d& at = localizer_.T_map_base().translation;
  std::string reason = "no advance";
  if (!stalls) {
    reason = "touched something";
  } else if (held_by_base_) {
    reason = "something seen is in the way";
  } else if (held_map_) {
    reason =
        fmt::format("what is known at ({:.2f}, {:.2f}) m is in the way", held_map_->x(), held_map_->y());
  }
  return fmt::format("{} at ({:.2f}, {:.2f}) m", reason, at.x(), at.y());
}

DriveReport PathDrive::Run() {
  const double start = robot_.Now();
  bool held_at_start = robot_.State().blocked;  // stays so until the robot has moved
  DriveGuide guide(task_, options_.follow);
  while (robot_.Now() < start + options_.max_time) {
    if (MustStop()) return Ended(DriveEnd::kStopped);
    const std::optional<control::DriveCommand> wanted = guide.Next(localizer_.T_map_base());
    if (!wanted) return Ended(DriveEnd::kArrived);
    guide.Note(GoAvoiding(*wanted, true));
    const bool touches = robot_.State().blocked;
    held_at_start = held_at_start && touches && robot_.Now() < start + kStartingTime;
    const bool gives_up = Stalls();
    if (!gives_up && (!touches || held_at_start)) continue;
    report_.reason = Reason(gives_up);
    if (gives_up && !held_by_base_) report_.held_map = held_map_;
    Halt();
    if (!gives_up) held_by_base_ = ContactPlace(robot_, localizer_.scanner(), *wanted);
    if (held_by_base_) report_.obstacles_map.push_back(localizer_.T_map_base() * *held_by_base_);
    BackOff();
    break;
  }
  if (report_.reason.empty()) report_.reason = "not there in time";
  return Ended(DriveEnd::kBlocked);
}

}  // namespace

DriveReport DrivePath(drivers::Robot& robot, Localizer localizer, const DriveTask& task,
                      const DriveOptions& options, const std::function<bool()>& stop) {
  return PathDrive(robot, std::move(localizer), task, options, stop).Run();
}

}  // namespace ariadne::experiments
