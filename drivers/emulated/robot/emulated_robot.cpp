#include "drivers/emulated/robot/emulated_robot.h"

#include <fmt/format.h>

#include <numbers>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/range_finder.h"

namespace ariadne::drivers {
namespace {

/// What the device can say: its unit, and how many bits of a word are the distance.
RangeMode RangeModeOf(const lms200::Config& config) {
  if (lms200::UnitOf(config) == lms200::LengthUnit::kCentimetre) return RangeMode::kCm80m;
  const int bits = lms200::DistanceBits(lms200::MeasuringModeOf(config));
  return bits == 15 ? RangeMode::kMm32m : bits == 14 ? RangeMode::kMm16m : RangeMode::kMm8m;
}

}  // namespace

EmulatedRobot::EmulatedRobot(std::shared_ptr<const RayScene> scene, const SimulatedBaseOptions& base,
                             const AisScannerOptions& ais, const EmulatedRobotOptions& options,
                             std::uint64_t seed)
    : scene_(std::move(scene)),
      drive_(base.drive),
      ais_(ais),
      options_(options),
      seed_(seed),
      base_(scene_->world(), base, seed),
      scanner_(options.scanner, [this](double stamp, const slam::ScannerModel& scanner,
                                       std::size_t beams) { return Measure(stamp, scanner, beams); }),
      servo_(options.servo),
      hobby_servo_(options.hobby_servo),
      motors_(options.motors) {
  CheckOptions(options, "emulated.");
  CheckOptions(ais, "ais.");
  motors_.SetLoad([this](const std::array<double, 2>& pulses, double time) { return Roll(pulses, time); });
}

double EmulatedRobot::Roll(const std::array<double, 2>& pulses, double time) {
  const double meters = drive_.MetersPerTick();
  return base_.Roll({meters * pulses[0] * (1.0 - slip_[0]), meters * pulses[1] * (1.0 - slip_[1])}, time);
}

EmulatedDevice& EmulatedRobot::mount() {
  if (options_.servo_kind == ServoKind::kHobby) return hobby_servo_;
  return servo_;
}

void EmulatedRobot::SetStuck(bool stuck) {
  servo_.SetStuck(stuck);
  hobby_servo_.SetStuck(stuck);
}

/// Larger positions look up [rad].
double EmulatedRobot::PitchAt(double time) const {
  if (options_.servo_kind == ServoKind::kHobby)
    return (hobby_servo_.PositionAt(time) - options_.level_pulse) / options_.pulse_per_radian;
  return 2.0 * std::numbers::pi * (servo_.PositionAt(time) - options_.level / 360.0);
}

slam::LaserSweep EmulatedRobot::Measure(double stamp, const slam::ScannerModel& scanner,
                                        std::size_t beams) {
  const double duration = scanner.turn_period * scanner.turns_per_sweep;
  if (catch_up_) catch_up_(stamp + duration);
  motors_.Couple();
  const double pitch = PitchAt(stamp);
  const double rate = (PitchAt(stamp + duration) - pitch) / duration;
  SweepMounting mounting = AisMounting(ais_);
  mounting.scanner = scanner;
  mounting.beams = beams;
  RangeFinderOptions finder = ais_.range_finder;
  finder.mode = RangeModeOf(scanner_.config());
  const RangeFinder device("ais", finder, seed_);
  const auto rays = SweepBeams(mounting, base_.WayBetween(stamp, stamp + duration), stamp, pitch, rate);
  return device.Measure(*scene_, rays, fmt::format("emulated/{}", sweeps_++));
}

}  // namespace ariadne::drivers
