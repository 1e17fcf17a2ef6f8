#include <algorithm>
#include <cmath>

#include "drivers/hardware/robot/hardware_robot.h"
#include "drivers/hardware/robot/stopping_wheels.h"

namespace ariadne::drivers {
namespace {

constexpr double kSweepWait = 0.2;  // for a sweep, before the scanner is looked for [s]

}  // namespace

double HardwareRobot::SweepDuration() const {
  const slam::ScannerModel scanner = scanner_.scanner();
  return scanner.turn_period * scanner.turns_per_sweep;
}

/// While a scan is taken: the range in as many sweeps as it should have.
double HardwareRobot::TiltRate() const {
  return (options_.tilt.to - options_.tilt.from) / (options_.tilt.slices * SweepDuration());
}

/// By the robot's clock.
slam::LaserSweep HardwareRobot::Stamped(slam::LaserSweep sweep) const {
  sweep.stamp -= start_;
  return sweep;
}

/// Hears the scanner meanwhile, so that no line is full when it is listened to again.
void HardwareRobot::WaitForMount(double angle) {
  constexpr double kLook = 0.02;  // [s]
  const double give_up = LineNow() + options_.tilt.max_time;
  while (std::abs(mount_->State().angle - angle) > options_.tilt.tolerance) {
    if (LineNow() > give_up) mount_->FailStanding(angle);
    KeepSweepsUntil(LineNow() + kLook);
  }
  if (mount_->settling() > 0.0) KeepSweepsUntil(LineNow() + mount_->settling());
}

/// Returns when the mount stands level.
void HardwareRobot::Level() {
  if (level_) return;
  if (!levelling_) {
    mount_->SetProfile(options_.tilt.fast, options_.tilt.acceleration);
    mount_->MoveTo(0.0);
    levelling_ = true;
  }
  WaitForMount(0.0);
  level_ = true;
  levelling_ = false;
}

void HardwareRobot::Stream() {
  Level();
  if (scanner_.streaming()) return;
  latest_.reset();
  scanner_.StartStream();
}

/// Lets time pass, and hears what the scanner sends meanwhile: what is read late has no time.
void HardwareRobot::KeepSweepsUntil(double line_time) {
  if (!scanner_.streaming()) return DiscardUntil(base_line_, line_time);
  while (std::optional<Lms200Sweep> sweep = scanner_.PollSweep(line_time))
    latest_ = std::move(sweep->sweep);
}

/// The first one that begins after a time, or the newest of those. Waits for it; where it does not come,
/// the wheels are stopped, and the scanner is looked for.
slam::LaserSweep HardwareRobot::SweepAfter(double line_time) {
  KeepSweepsUntil(LineNow());
  const double wait_until = std::max(line_time, LineNow()) + kSweepWait;
  while (!latest_ || latest_->stamp < line_time) {
    std::optional<Lms200Sweep> sweep = scanner_.PollSweep(wait_until);
    if (!sweep) {
      Halt();
      sweep = scanner_.NextSweep();
    }
    latest_ = std::move(sweep->sweep);
  }
  return *latest_;
}

slam::LaserSweep HardwareRobot::TakeSweep() {
  return StoppingWheels([&] {
    Stream();
    return Stamped(SweepAfter(LineNow() - options_.sweep_age));
  });
}

slam::Scan HardwareRobot::TakeScan() {
  return StoppingWheels([&] {
    Halt();
    for (int repeats = 0;; ++repeats) {
      Stream();
      const SafetySweep before{T_base_laser(), scanner_.scanner(), SweepAfter(LineNow())};
      std::optional<slam::Scan> scan = TryScan();
      Stream();
      const SafetySweep after{T_base_laser(), scanner_.scanner(), SweepAfter(LineNow())};
      const std::vector<std::vector<SafetySweep>> frames{{before}, {after}};
      const bool last = repeats >= options_.frames.max_repeats;
      if (!scan && last) Fail("no scan without gaps in {} tries; see the scanner's cable", repeats + 1);
      if (scan && (last || DetectMotion(frames, options_.frames).empty())) {
        scanner_.StopStream();
        ReadBase();
        scan->odometry = state_.odometry;  // of the whole scan: the robot stands
        return std::move(*scan);
      }
      ++repeated_scans_;
    }
  });
}

/// None where slices are missing.
std::optional<slam::Scan> HardwareRobot::TryScan() {
  const TiltOptions& tilt = options_.tilt;
  const double rate = TiltRate();
  const double lead = LeadOf(tilt, rate, SweepDuration(), mount_->lag());
  level_ = false;
  mount_->MoveTo(tilt.from - lead);
  WaitForMount(tilt.from - lead);
  latest_.reset();
  SweepAfter(LineNow());  // from now on they have times
  mount_->SetProfile(rate, tilt.acceleration);
  mount_->MoveTo(tilt.to + lead);
  TiltTrack track(tilt.window);
  std::vector<slam::LaserSweep> sweeps = SweepsWhileTilting(track);
  mount_->SetProfile(tilt.fast, tilt.acceleration);
  mount_->MoveTo(0.0);
  levelling_ = true;
  latest_.reset();
  return ScanOf(std::move(sweeps), track);
}

/// The servo is asked right after a sweep has come: it has answered before the next one does.
std::vector<slam::LaserSweep> HardwareRobot::SweepsWhileTilting(TiltTrack& track) {
  const TiltOptions& tilt = options_.tilt;
  const double give_up = LineNow() + tilt.slices * SweepDuration() + tilt.max_time;
  const double enough = tilt.to + 0.5 * TiltRate() * tilt.window;
  std::vector<slam::LaserSweep> sweeps;
  for (double angle = tilt.from - 1.0; angle < enough;) {
    std::optional<Lms200Sweep> sweep = scanner_.PollSweep(LineNow() + kSweepWait);
    if (!sweep) sweep = scanner_.NextSweep();
    sweeps.push_back(std::move(sweep->sweep));
    const MountState state = mount_->State();
    track.Add(state.time, state.angle);
    angle = state.angle;
    if (LineNow() > give_up)
      Fail("the mount stands at {:.3f} rad on its way to {:.3f}; see what holds it", angle, tilt.to);
  }
  return sweeps;
}

/// Slices whose middle is in the range that a scan covers.
std::optional<slam::Scan> HardwareRobot::ScanOf(std::vector<slam::LaserSweep> sweeps,
                                                const TiltTrack& track) const {
  const TiltOptions& tilt = options_.tilt;
  slam::Scan scan;
  scan.scanner = scanner_.scanner();
  double previous = tilt.from;
  for (slam::LaserSweep& sweep : sweeps) {
    const Tilt at = track.At(sweep.stamp);
    const double middle = at.angle + 0.5 * at.rate * SweepDuration();
    if (middle < tilt.from || middle > tilt.to) continue;
    if (middle - previous > tilt.max_gap) return std::nullopt;
    previous = middle;
    sweep.pitch = at.angle;
    sweep.pitch_rate = at.rate;
    scan.sweeps.push_back(Stamped(std::move(sweep)));
  }
  if (tilt.to - previous > tilt.max_gap) return std::nullopt;
  return scan;
}

}  // namespace ariadne::drivers
