#include "drivers/hardware/robot/hardware_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/hardware/robot/stopping_wheels.h"
#include "drivers/hardware/serial_port.h"

namespace ariadne::drivers {
namespace {

/// Who has gone so far from what held the wheels is free of it.
constexpr double kClearOf = 0.02;                     // [m]
constexpr double kClearTurn = slam::RadFromDeg(2.0);  // [rad]
constexpr double kHaltTime = 5.0;                     // [s]
constexpr double kPollTime = 0.05;                    // of the base, while waiting [s]

const HardwareRobotOptions& CheckedRobot(const HardwareRobotOptions& options) {
  CheckOptions(options, "hardware.");
  const TiltOptions& tilt = options.tilt;
  if (tilt.from >= tilt.to) Fail("hardware.tilt.from must be smaller than hardware.tilt.to");
  const double duration = options.scanner.turn_period / options.scanner.resolution;
  const double lag = options.servo_kind == ServoKind::kHobby ? options.hobby_servo.lag : 0.0;
  const double lead = LeadOf(tilt, (tilt.to - tilt.from) / (tilt.slices * duration), duration, lag);
  const MountRange range = MountRangeOf(options);
  if (tilt.from - lead < range.min || tilt.to + lead > range.max) {
    Fail(
        "a scan from hardware.tilt.from={:.3f} to {:.3f} rad in {} slices needs {:.3f} rad more at both "
        "ends to set the mount in motion, but it bears {:.3f} to {:.3f} only (hardware.{}.min_angle "
        "and max_angle); take more slices, or a smaller range",
        tilt.from, tilt.to, tilt.slices, lead, range.min, range.max,
        options.servo_kind == ServoKind::kHobby ? "hobby_servo" : "servo");
  }
  return options;
}

std::unique_ptr<ByteStream> OpenPort(const std::string& device, const std::string& port) {
  if (port.empty()) {
    Fail(
        "hardware.{}.port is not given; name the port of that device, for example "
        "/dev/serial/by-id/usb-FTDI...; `ariadne devices` lists them",
        device);
  }
  constexpr int kFirstBaud = 9600;  // the drivers change it
  return OpenSerialPort(port, kFirstBaud);
}

}  // namespace

RobotLines OpenPorts(const HardwareRobotOptions& options) {
  return {OpenPort("scanner", options.scanner.port), OpenPort("servo", options.servo.port),
          OpenPort("motors", options.motors.port)};
}

HardwareRobot::HardwareRobot(RobotLines lines, const HardwareRobotOptions& options)
    : options_(CheckedRobot(options)),
      base_line_(*lines.motors),
      scanner_(std::move(lines.scanner), options.scanner),
      mount_(MakeTiltMount(std::move(lines.servo), options)),
      motors_(std::move(lines.motors), options.motors),
      start_(base_line_.Now()),
      odometry_(options.drive, options.odometry) {}

HardwareRobot::~HardwareRobot() { StopWheels(); }

void HardwareRobot::StopWheels() noexcept {
  target_ = {};
  try {
    motors_.Stop();
  } catch (const std::exception&) {  // then they stop by their timeout
  }
}

/// The wheels first: they may turn.
void HardwareRobot::Connect() {
  StoppingWheels([&] {
    motors_.Connect();
    mount_->Connect();
    mount_->SetProfile(options_.tilt.fast, options_.tilt.acceleration);
    mount_->Hold();
    mount_->MoveTo(0.0);
    levelling_ = true;
    scanner_.Connect();
    Level();
    ReadBase();
  });
}

/// An empty read tells a recorded line the time.
double HardwareRobot::LineNow() const {
  base_line_.Read(base_line_.Now());
  return base_line_.Now();
}

double HardwareRobot::Now() const { return LineNow() - start_; }

void HardwareRobot::ReadBase() {
  const roboclaw::EncoderCounts counts = motors_.Encoders();
  const roboclaw::Pair speeds = motors_.MeasuredSpeeds();
  if (!motors_.turning()) NoteInterruption();
  const std::size_t left = options_.swapped ? 1 : 0;
  const std::size_t right = 1 - left;
  const int left_sense = options_.left_reversed ? -1 : 1;
  const int right_sense = options_.right_reversed ? -1 : 1;
  const auto ticks = [](std::int32_t count, int sense) {
    const auto bits = static_cast<std::uint32_t>(count);
    return sense < 0 ? 0U - bits : bits;
  };
  const double meters = options_.drive.MetersPerTick();
  const control::WheelPair rims{meters * left_sense * speeds[left], meters * right_sense * speeds[right]};
  state_.odometry =
      odometry_.Update({ticks(counts.counts[left], left_sense), ticks(counts.counts[right], right_sense)});
  state_.velocity = {0.5 * (rims.left + rims.right), (rims.right - rims.left) / options_.drive.track};
  const double before = std::exchange(state_.stamp, counts.time - start_);
  // Who was not heard for so long stands by the board's own timeout, and is held by nothing.
  if (state_.stamp - before > options_.motors.timeout) behind_since_.fill(state_.stamp);
  state_read_ = base_line_.Now();
  NoteStall(rims);
}

/// The board was silent for so long that the wheels were told to stop; they stand until the next command.
void HardwareRobot::NoteInterruption() {
  if (target_.left == 0.0 && target_.right == 0.0) return;
  target_ = {};
  ++interruptions_;
}

void HardwareRobot::NoteStall(const control::WheelPair& speeds) {
  const std::array<double, 2> told{target_.left, target_.right};
  const std::array<double, 2> measured{speeds.left, speeds.right};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool behind =
        std::abs(told[i]) >= options_.stall.min_speed && measured[i] / told[i] < options_.stall.share;
    if (!behind) behind_since_[i] = state_.stamp;
    if (state_.stamp - behind_since_[i] < options_.stall.time) continue;
    stalled_at_ = state_.odometry.T_odom_base;
    target_ = {};
    motors_.Stop();
  }
  if (stalled_at_) {
    const slam::Pose2 moved = stalled_at_->Inverse() * state_.odometry.T_odom_base;
    if (moved.translation.norm() > kClearOf || std::abs(moved.angle) > kClearTurn) stalled_at_.reset();
  }
  state_.blocked = stalled_at_.has_value();
}

RobotState HardwareRobot::State() {
  return StoppingWheels([&] {
    if (LineNow() - state_read_ > options_.state_age) ReadBase();
    return state_;
  });
}

void HardwareRobot::Drive(const Velocity& velocity) {
  StoppingWheels([&] {
    if (!std::isfinite(velocity.forward) || !std::isfinite(velocity.turning))
      Fail("the wheels cannot turn at {} m/s and {} rad/s", velocity.forward, velocity.turning);
    const bool moves = velocity.forward != 0.0 || velocity.turning != 0.0;
    if (moves) Stream();  // to see where it goes
    const control::DriveCommand command =
        control::Saturated({velocity.forward, velocity.turning}, options_.limits);
    const control::WheelPair before =
        std::exchange(target_, control::WheelsOf(command.forward, command.turning, options_.drive.track));
    const double now = base_line_.Now() - start_;
    if (std::abs(before.left) < options_.stall.min_speed) behind_since_[0] = now;  // it was not to turn
    if (std::abs(before.right) < options_.stall.min_speed) behind_since_[1] = now;
    const double pulses = 1.0 / options_.drive.MetersPerTick();
    roboclaw::Pair speeds{pulses * target_.left * (options_.left_reversed ? -1.0 : 1.0),
                          pulses * target_.right * (options_.right_reversed ? -1.0 : 1.0)};
    if (options_.swapped) std::swap(speeds[0], speeds[1]);
    if (!motors_.SetSpeeds(speeds, pulses * options_.wheel_acceleration)) NoteInterruption();
  });
}

void HardwareRobot::WaitUntil(double time) {
  if (!std::isfinite(time)) Fail("the robot cannot wait until {} s", time);
  StoppingWheels([&] {
    const double end = time + start_;
    for (double now = LineNow(); now < end; now = LineNow()) {
      KeepSweepsUntil(std::min(end, now + kPollTime));
      const bool turn = target_.left != 0.0 || target_.right != 0.0;
      if (turn && LineNow() < end - kPollTime) ReadBase();
    }
  });
}

void HardwareRobot::Halt() {
  Drive({});
  const double give_up = LineNow() + kHaltTime;
  do {
    ReadBase();
    if (LineNow() > give_up) Fail("the wheels do not stand still; switch the motors off");
  } while (state_.velocity.forward != 0.0 || state_.velocity.turning != 0.0);
}

}  // namespace ariadne::drivers
