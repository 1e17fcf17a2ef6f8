#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/emulated/emulated_lms200.h"

namespace ariadne::drivers {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// The mean of what came back, beam by beam.
slam::LaserSweep MeanOf(const std::vector<slam::LaserSweep>& sweeps) {
  slam::LaserSweep mean = sweeps.front();
  for (std::size_t beam = 0; beam < mean.ranges.size(); ++beam) {
    double sum = 0.0;
    int count = 0;
    for (const slam::LaserSweep& sweep : sweeps) {
      if (!std::isfinite(sweep.ranges[beam])) continue;
      sum += static_cast<double>(sweep.ranges[beam]);
      ++count;
    }
    mean.ranges[beam] = count == 0 ? slam::LaserSweep::kNoReturn : static_cast<float>(sum / count);
  }
  return mean;
}

}  // namespace

int EmulatedLms200::TurnsOfMeasuring() const { return measuring_->partial ? 1 : lms200::TurnsOf(variant_); }

/// Of the next turn.
std::size_t EmulatedLms200::BeamsOfMeasuring() const {
  if (!measuring_->partial) return lms200::BeamsOf(variant_);
  return variant_.field_of_view + (next_turn_ % 4 == 0 ? std::size_t{1} : std::size_t{0});
}

/// Sweeps follow each other without a gap from the mirror's first turn on.
double EmulatedLms200::SweepEnd() const {
  return ready_at_ + static_cast<double>(next_turn_ + TurnsOfMeasuring()) * options_.turn_period;
}

/// The end of a sweep. `next_turn_` is 0 after a command, and goes to where the mirror is.
void EmulatedLms200::Measure() {
  const int turns = TurnsOfMeasuring();
  const double end = SweepEnd();
  const std::int64_t turn = next_turn_;
  const double now = std::max({end, now_, sent_until_});
  if (now > end + 1e-9) {  // the sweep ended before it was asked for, or while the line was busy
    const double passed = (now - ready_at_) / (turns * options_.turn_period);
    const auto sweeps = static_cast<std::int64_t>(std::ceil(passed - 1e-9)) - 1;
    next_turn_ = std::max(turn + turns, sweeps * turns);
    return;
  }
  lms200::MeasuredValues values = Values(turn);
  next_turn_ = turn + turns;
  if (values.words.empty()) return;  // of a mean that needs more sweeps
  Transmit(end, lms200::EncodeTelegram({lms200::kFromDevice, lms200::EncodeReply(values)}));
  if (measuring_->left > 0 && --measuring_->left == 0) measuring_.reset();
}

lms200::MeasuredValues EmulatedLms200::Values(std::int64_t turn) {
  const Measuring& measuring = *measuring_;
  lms200::MeasuredValues values;
  values.code = measuring.code;
  values.unit = lms200::UnitOf(config_);
  values.partial = measuring.partial;
  values.offset = measuring.partial ? static_cast<int>(turn % 4) : 0;
  values.status = status_;

  slam::ScannerModel scanner;
  const double first = variant_.field_of_view == 100 ? 40.0 : 0.0;
  scanner.first_angle = (first + 0.25 * values.offset) * kRadians;
  scanner.angle_step = (measuring.partial ? 1.0 : variant_.resolution / 100.0) * kRadians;
  scanner.turns_per_sweep = TurnsOfMeasuring();
  scanner.turn_period = options_.turn_period;
  const double stamp = ready_at_ + static_cast<double>(turn) * options_.turn_period;
  mean_.push_back(source_(stamp, scanner, BeamsOfMeasuring()));
  if (static_cast<int>(mean_.size()) < measuring.samples) return values;
  const slam::LaserSweep sweep = mean_.size() == 1 ? mean_.front() : MeanOf(mean_);
  mean_.clear();

  values.words = WordsOf(sweep);
  if (measuring.samples > 1) values.samples = static_cast<std::uint8_t>(measuring.samples);
  if (measuring.code == 0xB7 || measuring.code == 0xBF || measuring.code == 0xC4) {
    values.first = measuring.first;
    values.last = measuring.last;
  }
  const auto begin = static_cast<std::ptrdiff_t>(measuring.first) - 1;
  if (measuring.code == 0xC4) {
    for (std::ptrdiff_t beam = begin; beam < measuring.last; ++beam) {
      const float share =
          sweep.reflectance.empty() ? 0.0F : sweep.reflectance[static_cast<std::size_t>(beam)];
      values.reflectivity.push_back(static_cast<std::uint8_t>(std::lround(share * 255.0F)));
    }
  } else if (values.last > 0) {
    values.words = {values.words.begin() + begin, values.words.begin() + measuring.last};
  }
  if (lms200::HasRealTimeIndices(config_)) {
    values.indices = lms200::RealTimeIndices{static_cast<std::uint8_t>(turn & 0xFF), telegrams_++};
  }
  return values;
}

std::vector<std::uint16_t> EmulatedLms200::WordsOf(const slam::LaserSweep& sweep) const {
  const lms200::MeasuringMode mode = lms200::MeasuringModeOf(config_);
  const int bits = lms200::DistanceBits(mode);
  const long too_far = (1L << bits) - 9;  // 0x1FF7 of 13 bits
  const int levels = lms200::ReflectorLevels(mode);
  std::vector<std::uint16_t> words;
  for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
    const float share = sweep.reflectance.empty() ? 0.0F : sweep.reflectance[beam];
    if (mode == lms200::MeasuringMode::kReflectivity) {
      words.push_back(static_cast<std::uint16_t>(std::lround(share * 255.0F)));
      continue;
    }
    const double range = static_cast<double>(sweep.ranges[beam]);
    long number = too_far;
    if (std::isfinite(range)) {
      number = std::min(too_far, std::lround(range / lms200::Metres(lms200::UnitOf(config_))));
    }
    const long level = std::lround(share * static_cast<float>(levels));
    words.push_back(static_cast<std::uint16_t>(std::max(0L, number) | level << bits));
  }
  return words;
}

}  // namespace ariadne::drivers
