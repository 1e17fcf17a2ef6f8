#include "experiments/mission/drive_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/mission/beside_memory.h"
#include "experiments/mission/contact.h"
#include "experiments/mission/way_back.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kSlow = 0.15;         // when backing off [m/s]
constexpr double kSlowTurning = 0.3;   // [rad/s]
constexpr double kHaltTime = 6.0;      // [s]
constexpr double kStartingTime = 6.0;  // a contact at the start has so long to clear [s]
constexpr double kAdvance = 0.08;      // [m]
constexpr double kAdvanceTurn = 0.12;  // [rad]
constexpr double kLeft = 0.06;         // [m]
constexpr double kLeftTurn = 0.1;      // [rad]
constexpr double kWriggleTime = 1.5;   // for one motion [s]
constexpr int kWriggles = 2;           // rounds
constexpr double kWithin = -0.03;      // the robot: cells that are coarser than what occupies them [m]
constexpr double kSeenError = 0.015;   // of the scanners [m]
constexpr double kOffPath = 0.02;      // by the controller and the localization [m]
constexpr double kOfKnown = 0.3;       // from what the map knows: what is seen there stands [m]
constexpr double kLookAhead = 0.5;     // for what moves, beyond the time to stop [s]

double TurnBetween(const slam::Pose2& a, const slam::Pose2& b) {
  return std::abs(slam::WrapAngle(a.angle - b.angle));
}

/// What leads to the goal: along the path, or by the paper's controller.
class Guide {
 public:
  Guide(const DriveTask& task, const control::FollowOptions& follow) : task_(task), follow_(follow) {}

  /// For the next period; nothing where the robot has arrived.
  std::optional<control::DriveCommand> Next(const slam::Pose2& T_map_base) {
    if (!task_.approach) {
      const control::FollowStep step = control::FollowPath(task_.path_map, T_map_base, on_path_, follow_);
      on_path_ = step.progress;
      return step.finished ? std::nullopt : std::optional(step.command);
    }
    const ApproachTask& approach = *task_.approach;
    const control::ApproachStep step = control::StepApproach(
        approach.T_map_goal.Inverse() * T_map_base, approaching_, approach.behaviour, approach.options);
    approaching_ = step.progress;
    return step.finished ? std::nullopt : std::optional(step.command);
  }

  /// What the robot was told instead.
  void Note(const control::DriveCommand& command) { on_path_.command = approaching_.command = command; }

 private:
  const DriveTask& task_;
  const control::FollowOptions& follow_;
  control::PathProgress on_path_;
  control::ApproachProgress approaching_;
};

/// A drive under way.
class PathDrive {
 public:
  PathDrive(drivers::Robot& robot, Localizer localizer, const DriveTask& task, const DriveOptions& options,
            const std::function<bool()>& stop)
      : robot_(robot),
        localizer_(std::move(localizer)),
        task_(task),
        options_(options),
        avoid_(options.avoid),
        stop_(stop),
        moving_(options.moving) {
    avoid_.robot.margin = std::min(avoid_.robot.margin, std::max(kSeenError, task.margin - kOffPath));
    known_margin_ = std::max(0.0, task.margin - kOffPath - avoid_.robot.margin);
    const slam::Pose2 start = localizer_.T_map_base();
    report_.poses_map.push_back(start);
    advanced_to_ = start;
    advanced_at_ = robot.Now();
    KeepInMind(task.obstacles_map);
  }

  DriveReport Run();

 private:
  void NoteAdvance();
  void KeepInMind(std::span<const Eigen::Vector2d> obstacles_map);
  bool Stalls() const { return robot_.Now() - advanced_at_ > options_.patience; }
  bool MustStop() const { return stop_ && stop_(); }
  std::vector<Eigen::Vector2d> KnownInTheWay() const;
  Eigen::Vector2d Nearer(const Eigen::Vector2d& p_base) const;
  std::vector<Eigen::Vector2d> ToCome(std::span<const drivers::SafetySweep> sweeps,
                                      const drivers::RobotState& state);
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
  control::AvoidanceOptions avoid_;  // with no more margin than the path has
  double known_margin_ = 0.0;        // more of it, for what only the map knows, which errs more [m]
  const std::function<bool()>& stop_;
  slam::Pose2 advanced_to_;
  double advanced_at_ = 0.0;                     // [s]
  double due_ = 0.0;                             // the next command: real robots take time to answer [s]
  std::optional<Eigen::Vector2d> held_by_base_;  // that the scanners see
  BesideMemory beside_;
  MovingThings moving_;
  std::vector<Eigen::Vector2d> known_map_;
  std::optional<Eigen::Vector2d> held_map_;  // that the scanners see, or the map knows
  DriveReport report_;
};

/// What the map knows, but for what the robot stands in already, and for what would stand where it has
/// been: there the map errs.
void PathDrive::KeepInMind(std::span<const Eigen::Vector2d> obstacles_map) {
  control::RectangleOptions bare = avoid_.robot;
  bare.margin = 0.0;
  std::vector<control::PlacedRectangle> been;
  for (std::size_t i = 0; i < task_.retraced; ++i) been.emplace_back(bare, task_.path_map[i]);
  const control::PlacedRectangle at_start(bare, localizer_.T_map_base());
  const double close = avoid_.robot.margin + known_margin_;
  for (const Eigen::Vector2d& p_map : obstacles_map) {
    const bool stood = at_start.GapTo(p_map) <= kWithin;
    if (!stood &&
        std::ranges::none_of(been, [&](const auto& robot) { return robot.GapTo(p_map) <= close; }))
      known_map_.push_back(p_map);
  }
}

/// A place that errs by the known margin, as near ahead and beside as it may be.
Eigen::Vector2d PathDrive::Nearer(const Eigen::Vector2d& p_base) const {
  const Eigen::Array2d half(0.5 * avoid_.robot.length, 0.5 * avoid_.robot.width);
  const Eigen::Array2d from_centre = p_base - Eigen::Vector2d(avoid_.robot.centre_ahead, 0.0);
  const Eigen::Array2d nearer = (from_centre.abs() - half).max(0.0).min(known_margin_);
  return p_base - (from_centre.sign() * nearer).matrix();
}

/// Obstacles that the map knows, nearby in the robot's frame, but for those that it stands beside: cells
/// are coarse, and it must be able to leave.
std::vector<Eigen::Vector2d> PathDrive::KnownInTheWay() const {
  std::vector<Eigen::Vector2d> points_base;
  const slam::Pose2 T_map_base = localizer_.T_map_base(), T_base_map = T_map_base.Inverse();
  const Eigen::Matrix2d R_base_map = T_base_map.RotationMatrix();
  for (const Eigen::Vector2d& p_map : known_map_) {
    if ((p_map - T_map_base.translation).norm() < options_.known_within)
      points_base.push_back(Nearer(R_base_map * p_map + T_base_map.translation));
  }
  return points_base;
}

/// Where what moves will be until the robot stands, if it brakes now; in its frame.
std::vector<Eigen::Vector2d> PathDrive::ToCome(std::span<const drivers::SafetySweep> sweeps,
                                               const drivers::RobotState& state) {
  if (!options_.moving.watch) return {};
  const slam::Pose2 &T_odom_base = state.odometry.T_odom_base, T_base_odom = T_odom_base.Inverse();
  std::vector<Eigen::Vector2d> points = PointsOf(sweeps);
  for (Eigen::Vector2d& p : points) p = T_odom_base * p;
  moving_.Update(points, T_odom_base.translation, state.stamp);
  const double braking = std::max(std::abs(state.velocity.forward) / avoid_.limits.acceleration,
                                  std::abs(state.velocity.turning) / avoid_.limits.turning_acceleration);
  const slam::Pose2 T_map_odom = localizer_.T_map_base() * T_base_odom;
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

/// Returns what it did instead of what was wanted.
control::DriveCommand PathDrive::GoAvoiding(const control::DriveCommand& wanted, bool known) {
  control::DriveCommand command = wanted;
  held_by_base_.reset();
  held_map_.reset();
  if (options_.avoid_obstacles) {
    const drivers::RobotState state = robot_.State();
    const drivers::Velocity& velocity = state.velocity;
    const std::vector<drivers::SafetySweep> sweeps = LookAround(robot_, localizer_.scanner(), state);
    std::vector<Eigen::Vector2d> points_base = beside_.Update(sweeps, state.odometry.T_odom_base);
    const std::size_t seen = points_base.size();
    const std::vector<Eigen::Vector2d> to_come = ToCome(sweeps, state);
    points_base.insert(points_base.end(), to_come.begin(), to_come.end());
    if (known) {
      const std::vector<Eigen::Vector2d> more = KnownInTheWay();
      points_base.insert(points_base.end(), more.begin(), more.end());
    }
    const control::AvoidanceResult avoided =
        control::Avoid(wanted, {velocity.forward, velocity.turning}, points_base, avoid_);
    command = avoided.command;
    if (avoided.p_base) held_map_ = localizer_.T_map_base() * *avoided.p_base;
    if (avoided.blocked && avoided.p_base &&
        std::find(points_base.begin(), points_base.begin() + static_cast<std::ptrdiff_t>(seen),
                  *avoided.p_base) != points_base.begin() + static_cast<std::ptrdiff_t>(seen))
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
  return report_;
}

bool PathDrive::HasLeft(const slam::Pose2& place) const {
  const slam::Pose2& now = localizer_.T_map_base();
  return (now.translation - place.translation).norm() > kLeft || TurnBetween(now, place) > kLeftTurn;
}

/// Away from what the robot touches: the way that it came, and if that is barred, any that is not.
void PathDrive::BackOff() {
  const slam::Pose2 touching = localizer_.T_map_base();
  FollowBack(robot_.Now());
  if (!HasLeft(touching)) Wriggle();
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
  Guide guide(task_, options_.follow);
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
