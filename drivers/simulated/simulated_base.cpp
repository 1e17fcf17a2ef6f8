#include "drivers/simulated/simulated_base.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam/geometry/angles.h"

namespace ariadne::drivers {
namespace {

/// Who has gone so far from a contact is free of it; less may be slip while pushing against the same thing.
constexpr double kClearDistance = 0.02;                // [m]
constexpr double kClearAngle = slam::RadFromDeg(2.0);  // [rad]

constexpr int kHalvings = 10;  // of a step until contact

constexpr double kInstant = 1e-6;  // of a step: no step is only a rounding error long

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

SimulatedBase::SimulatedBase(const World& world, const SimulatedBaseOptions& options, std::uint64_t seed)
    : obstacles_(world, options.footprint),
      wheels_(options.drive, options.wheels, seed),
      odometry_(options.drive, options.odometry),
      step_(options.step),
      command_timeout_(options.command_timeout),
      stale_at_(kNever),
      T_map_base_(world.T_map_start),
      path_{{0.0, world.T_map_start}} {
  CheckOptions(options, "base.");
  odometry_.Update(wheels_.Ticks());
  const Contact contact = obstacles_.ContactAt(T_map_base_, 0.0);
  if (contact.depth > 0.0) {
    Fail(
        "{}: the robot would start at ({:.2f} m, {:.2f} m) inside of \"{}\"; move the start by {:.2f} m or "
        "more",
        world.name, T_map_base_.translation.x(), T_map_base_.translation.y(),
        world.bodies[contact.body].name, contact.depth);
  }
}

void SimulatedBase::Drive(const Velocity& velocity) {
  wheels_.Command(velocity);
  const bool stop = velocity.forward == 0.0 && velocity.turning == 0.0;
  stale_at_ = command_timeout_ > 0.0 && !stop ? now_ + command_timeout_ : kNever;
}

void SimulatedBase::WaitUntil(double time) {
  if (!std::isfinite(time)) Fail("the robot cannot wait until {} s", time);
  while (now_ < time) {
    if (wheels_.idle()) {
      now_ = time;
    } else {
      const double next = NextStep();
      StepUntil(time < next + kInstant * step_ ? time : next);
    }
  }
}

void SimulatedBase::Halt() {
  Drive({});
  while (!wheels_.stands()) StepUntil(NextStep());
}

RobotState SimulatedBase::State() const {
  return {now_, odometry_.odometry(), wheels_.velocity(), contact_.has_value()};
}

/// Steps end at multiples of their length, so that waiting in pieces gives the same motion, and where a
/// command becomes stale.
double SimulatedBase::NextStep() const {
  const double next = (std::floor(now_ / step_ + kInstant) + 1.0) * step_;
  const bool stale_before = stale_at_ > now_ + kInstant * step_ && stale_at_ < next - kInstant * step_;
  return stale_before ? stale_at_ : next;
}

void SimulatedBase::BrakeIfStale() {
  if (now_ < stale_at_ - kInstant * step_) return;
  wheels_.Command({});
  stale_at_ = kNever;
}

void SimulatedBase::StepUntil(double time) {
  BrakeIfStale();
  MoveBy(wheels_.Accelerate(time - now_), time);
}

double SimulatedBase::Roll(const control::WheelPair& ways, double time) {
  if (!(time > now_)) return 1.0;
  if (ways.left != 0.0 || ways.right != 0.0) return MoveBy(wheels_.Roll(ways), time);
  now_ = time;
  return 1.0;
}

/// Returns the share of the step that nothing stopped.
double SimulatedBase::MoveBy(const WheelStep& step, double time) {
  const slam::Pose2 T_map_wanted = T_map_base_ * wheels_.Motion(step, 1.0);
  const bool free = MayGoTo(T_map_wanted, time);
  const double share = free ? 1.0 : ShareUntilContact(step, time);
  if (path_.back().time < now_) path_.push_back({now_, T_map_base_});
  T_map_base_ = T_map_base_ * wheels_.Motion(step, share);
  path_.push_back({time, T_map_base_});
  now_ = time;
  wheels_.Turn(step, share);
  if (!free) wheels_.Block();
  odometry_.Update(wheels_.Ticks());
  NoteContact(T_map_wanted, !free);
  return share;
}

bool SimulatedBase::MayGoTo(const slam::Pose2& T_map_base, double time) const {
  return !obstacles_.Block(T_map_base_, T_map_base, time);
}

double SimulatedBase::ShareUntilContact(const WheelStep& step, double time) const {
  double free = 0.0, blocked = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (free + blocked);
    (MayGoTo(T_map_base_ * wheels_.Motion(step, middle), time) ? free : blocked) = middle;
  }
  return free;
}

void SimulatedBase::NoteContact(const slam::Pose2& T_map_wanted, bool stopped) {
  if (stopped) {
    if (!contact_)
      collisions_.push_back(
          {now_, T_map_base_, obstacles_.NameOf(obstacles_.ContactAt(T_map_wanted, now_).body)});
    contact_ = T_map_base_;
  } else if (contact_) {
    const slam::Pose2 moved = contact_->Inverse() * T_map_base_;
    if (moved.translation.norm() > kClearDistance || std::abs(moved.angle) > kClearAngle) contact_.reset();
  }
}

Motion SimulatedBase::WayBetween(double from, double to) const {
  const auto earlier = [](double time, const TruePose& pose) { return time < pose.time; };
  auto pose = std::upper_bound(path_.begin(), path_.end(), from, earlier);
  if (pose != path_.begin()) --pose;  // the last one that is not after `from`
  Motion way;
  for (; pose != path_.end(); ++pose) {
    way.times.push_back(pose->time);
    way.T_map_body.push_back(slam::ToPose3(pose->T_map_base));
    if (pose->time >= to) break;
  }
  return way;
}

}  // namespace ariadne::drivers
