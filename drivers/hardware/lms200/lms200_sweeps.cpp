#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/hardware/lms200/lms200.h"

namespace ariadne::drivers {
namespace {

/// Of an echo. The specification gives no scale; in mode 0x3F it is that of the fast models' bytes.
constexpr float kLargestAmplitude = 255.0F;

}  // namespace

/// Whether it is what the scanner was asked for.
bool Lms200::IsExpected(const lms200::MeasuredValues& values) const {
  const lms200::Code code = options_.reflectivity ? lms200::Code::kReflectivity : lms200::Code::kScan;
  const std::size_t offset_beams = values.offset == 0 ? 181 : 180;
  return values.code == lms200::ReplyTo(code) && values.unit == unit_ && values.partial == partial_ &&
         values.words.size() == (partial_ ? offset_beams : beams_) &&
         (!options_.reflectivity || values.reflectivity.size() == beams_);
}

std::optional<Lms200Sweep> Lms200::Accept(const lms200::Link::Arrived& arrived) {
  const auto* values = std::get_if<lms200::MeasuredValues>(&arrived.reply);
  if (values == nullptr) return std::nullopt;
  const lms200::DeviceStatus status = lms200::DeviceStatusOf(values->status);
  FailIfBroken(status);
  if (!IsExpected(*values) || status.restart) {
    ++counters_.unexpected;
    return std::nullopt;
  }
  const std::optional<double> end = clock_.EndOf(arrived.time - link_.TimeOf(arrived.size), arrived.waited);
  if (!end) {
    ++counters_.no_time;
    parts_.clear();
    return std::nullopt;
  }
  Part part{*values, *end - options_.output_delay};
  if (partial_) return AddPart(std::move(part));
  return SweepOf({std::move(part)});
}

/// Turns must follow each other, in the order of their offsets.
std::optional<Lms200Sweep> Lms200::AddPart(Part part) {
  if (!parts_.empty()) {
    const double turns = (part.end - parts_.back().end) / options_.turn_period;
    const bool next = part.values.offset == static_cast<int>(parts_.size()) && std::abs(turns - 1.0) < 0.5;
    if (!next) {
      ++counters_.incomplete;
      parts_.clear();
    }
  }
  if (parts_.empty() && part.values.offset != 0) return std::nullopt;
  parts_.push_back(std::move(part));
  if (parts_.size() < std::size_t{lms200::kTurnsOfPartial}) return std::nullopt;
  const std::vector<Part> parts = std::exchange(parts_, {});
  return SweepOf(parts);
}

/// A sweep of one telegram, or of the turns of a partial one.
Lms200Sweep Lms200::SweepOf(const std::vector<Part>& parts) const {
  const bool reflects = lms200::ReflectorLevels(measuring_mode_) > 0 || options_.reflectivity ||
                        measuring_mode_ == lms200::MeasuringMode::kReflectivity;
  Lms200Sweep result;
  result.sweep.stamp = parts.front().end - options_.turn_period * lms200::TurnsOf(variant_);
  result.sweep.ranges.assign(beams_, slam::LaserSweep::kNoReturn);
  if (reflects) result.sweep.reflectance.resize(beams_);
  for (std::size_t first = 0; first < parts.size(); ++first) {
    const lms200::DeviceStatus status = lms200::DeviceStatusOf(parts[first].values.status);
    result.status.severity = std::max(result.status.severity, status.severity);
    result.status.implausible = result.status.implausible || status.implausible;
    result.status.polluted = result.status.polluted || status.polluted;
    PutBeams(parts[first].values, first, parts.size(), result);
  }
  return result;
}

/// Each `step`-th beam from `first` on.
void Lms200::PutBeams(const lms200::MeasuredValues& values, std::size_t first, std::size_t step,
                      Lms200Sweep& result) const {
  const bool amplitude = measuring_mode_ == lms200::MeasuringMode::kReflectivity;
  const int levels = lms200::ReflectorLevels(measuring_mode_);
  for (std::size_t i = 0; i < values.words.size(); ++i) {
    const lms200::Echo echo = lms200::EchoOf(values.words[i], measuring_mode_);
    const std::size_t beam = first + i * step;
    if (echo.error == lms200::ValueError::kNone && !amplitude) {
      result.sweep.ranges[beam] = static_cast<float>(echo.number * lms200::Metres(unit_));
    } else {
      ++result.no_distance;
    }
    if (result.sweep.reflectance.empty()) continue;
    float share = levels > 0 ? static_cast<float>(echo.flags) / static_cast<float>(levels) : 0.0F;
    if (amplitude) share = static_cast<float>(echo.number) / kLargestAmplitude;
    if (options_.reflectivity) share = static_cast<float>(values.reflectivity[i]) / kLargestAmplitude;
    result.sweep.reflectance[beam] = share;
  }
}

}  // namespace ariadne::drivers
