#include "drivers/simulated/range_errors.h"

#include <algorithm>
#include <cmath>

#include "slam/scan/scan.h"

namespace ariadne::drivers {
namespace {

constexpr double kKnotSpacing = 2.0;    // [m]
constexpr std::size_t kKnotCount = 42;  // to 82 m, the end of cm_80m

/// The top nine values of a field are error codes: 0x1FF7 to 0x1FFF of 13 bits.
constexpr double LargestValue(int bits) { return static_cast<double>((1 << bits) - 10); }

}  // namespace

RangeFinderOptions WithoutErrors(RangeFinderOptions options) {
  options.quantize = options.systematic = options.range_noise = options.dropouts = false;
  options.limit_by_reflectance = options.mixed_pixels = false;
  return options;
}

double RangeUnit(RangeMode mode) { return mode == RangeMode::kCm80m ? 0.01 : 0.001; }

double MaxRange(RangeMode mode) {
  const int bits = mode == RangeMode::kMm16m ? 14 : mode == RangeMode::kMm32m ? 15 : 13;
  return LargestValue(bits) * RangeUnit(mode);
}

SystematicError::SystematicError(const RangeFinderOptions& options, RandomStream stream) {
  if (!options.systematic) return;
  for (std::size_t i = 0; i < kKnotCount; ++i) {
    knots_.push_back(DrawUniform(stream, -1.0, 1.0) * options.systematic_limit);
  }
  if (options.systematic_shape == SystematicShape::kConstant) knots_.resize(1);
}

double SystematicError::At(double range) const {
  if (knots_.empty()) return 0.0;
  const double place = std::clamp(range / kKnotSpacing, 0.0, static_cast<double>(knots_.size() - 1));
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, knots_.size() - 1);
  const double s = place - static_cast<double>(below);
  const double smooth = s * s * (3.0 - 2.0 * s);  // stays between the knots, unlike a spline
  return knots_[below] + smooth * (knots_[above] - knots_[below]);
}

float ReportedRange(double range, const RangeFinderOptions& options) {
  const double unit = RangeUnit(options.mode);
  const double reported = options.quantize ? std::round(range / unit) * unit : range;
  const bool valid = reported > 0.0 && reported <= MaxRange(options.mode) + 1e-9;
  return valid ? static_cast<float>(reported) : slam::LaserSweep::kNoReturn;
}

float ReportedReflectance(double share, ReflectanceOutput output) {
  const double cut = std::clamp(share, 0.0, 1.0);
  if (output == ReflectanceOutput::kExact) return static_cast<float>(cut);
  const double levels = output == ReflectanceOutput::k3Bit ? 7.0 : 255.0;
  return static_cast<float>(std::round(cut * levels) / levels);
}

}  // namespace ariadne::drivers
