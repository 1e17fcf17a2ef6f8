#pragma once

#include <array>

#include "slam/base/options.h"

namespace ariadne::drivers {

/// Unit and field of the measured value of an LMS-200 (spec 9.2, 9.3): 13 bits in mm or cm, 14 or 15 in mm.
enum class RangeMode { kMm8m, kCm80m, kMm16m, kMm32m };

/// The systematic error of a device: the same at all ranges, or a smooth curve over range.
enum class SystematicShape { kConstant, kSmooth };

/// Which echo counts when a beam meets surfaces further apart than its pulse is long.
enum class EchoChoice { kFirst, kStrongest };

/// What the amount of returned light is: of the surface alone, or as it arrives.
enum class ReflectanceLaw { kSurface, kInverseSquare };

/// What the device tells of it (spec 9.4): nothing, 8 levels with every range, 256 levels, or a real
/// number.
enum class ReflectanceOutput { kNone, k3Bit, k8Bit, kExact };

/// A 2D laser range finder like the SICK LMS-200 and how it errs. Each source of error has a switch and
/// draws from a stream of its own, so that switching or changing one leaves the draws of the others alone.
struct RangeFinderOptions {
  RangeMode mode = RangeMode::kCm80m;
  bool quantize = true;
  bool systematic = true;
  double systematic_limit = 0.015;
  SystematicShape systematic_shape = SystematicShape::kSmooth;
  bool range_noise = true;
  double range_sigma = 0.005;
  bool dropouts = true;
  double dropout_share = 0.001;
  bool limit_by_reflectance = true;
  double reference_range = 10.0;
  double reference_reflectance = 0.1;
  bool mixed_pixels = true;
  double divergence = 0.0044;
  int rim_rays = 4;
  double pulse_length = 0.45;
  EchoChoice echo = EchoChoice::kFirst;
  ReflectanceOutput reflectance = ReflectanceOutput::k8Bit;
  ReflectanceLaw reflectance_law = ReflectanceLaw::kSurface;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("mode", self.mode,
          "unit and maximum range (spec 9.3); the paper plans with 15 m rays, beyond the 8 m of mm_8m");
    visit("quantize", self.quantize, "round ranges to the unit of the mode");
    visit("systematic", self.systematic, "give the device an error of its own, drawn once from the seed");
    visit("systematic_limit", self.systematic_limit, Unit("m"), Range{0.0, 1.0},
          "largest systematic error; spec 9.5: 15 mm at 1 to 8 m in mm mode, up to 40 mm in cm mode");
    visit("systematic_shape", self.systematic_shape,
          "smooth varies within a few metres of range, as calibrations of such devices find");
    visit("range_noise", self.range_noise, "add statistical noise to each range");
    visit("range_sigma", self.range_sigma, Unit("m"), Range{0.0, 1.0}, "its sigma; spec 9.5: 5 mm");
    visit("dropouts", self.dropouts, "lose some returns at random");
    visit("dropout_share", self.dropout_share, Unit(""), Range{0.0, 1.0},
          "how many; open, few: dark, wet and shiny spots that the world does not model");
    visit("limit_by_reflectance", self.limit_by_reflectance, "lose returns that are too weak");
    visit("reference_range", self.reference_range, Unit("m"), Range{0.1, 1e3},
          "how far a surface of reference_reflectance is seen head-on; LMS-200: 10 m at 10 %, and the echo "
          "falls with the square of the range");
    visit("reference_reflectance", self.reference_reflectance, Unit(""), Range{1e-3, 1.0},
          "of the surface that is seen as far as reference_range");
    visit("mixed_pixels", self.mixed_pixels,
          "the beam is a cone: at edges it hits two surfaces and measures a range between (spec 9.5)");
    visit("divergence", self.divergence, Unit("rad"), Range{0.0, 0.1},
          "full angle of the cone; 0.25 deg, the finest step that the LMS-200 takes");
    visit("rim_rays", self.rim_rays, Unit(""), Range{2, 64},
          "rays that stand for the cone, besides its centre");
    visit("pulse_length", self.pulse_length, Unit("m"), Range{0.0, 100.0},
          "surfaces closer together in range give one echo at their mean; open, half the length of 3 ns");
    visit("echo", self.echo,
          "which echo is measured when there are several; the LMS-200 stops at the first");
    visit("reflectance", self.reflectance,
          "levels of the reflectance, scaled to 1 for white paper; open in the paper (spec 9.4), 8 bits of "
          "the "
          "S14 show the shades of its Fig. 2");
    visit(
        "reflectance_law", self.reflectance_law,
        "surface: reflectance times cosine of incidence; inverse_square: falling with range too, 1 at 1 m");
  }
};

/// The same device without any error, and without a limit other than that of its mode.
RangeFinderOptions WithoutErrors(RangeFinderOptions options);

/// The unit of a mode, and its largest range: values above are error codes (spec 9.3) [m].
double RangeUnit(RangeMode mode);
double MaxRange(RangeMode mode);

}  // namespace ariadne::drivers

namespace ariadne {

template <>
struct EnumNames<drivers::RangeMode> {
  static constexpr std::array<std::string_view, 4> value{"mm_8m", "cm_80m", "mm_16m", "mm_32m"};
};
template <>
struct EnumNames<drivers::SystematicShape> {
  static constexpr std::array<std::string_view, 2> value{"constant", "smooth"};
};
template <>
struct EnumNames<drivers::EchoChoice> {
  static constexpr std::array<std::string_view, 2> value{"first", "strongest"};
};
template <>
struct EnumNames<drivers::ReflectanceLaw> {
  static constexpr std::array<std::string_view, 2> value{"surface", "inverse_square"};
};
template <>
struct EnumNames<drivers::ReflectanceOutput> {
  static constexpr std::array<std::string_view, 4> value{"none", "3_bit", "8_bit", "exact"};
};

}  // namespace ariadne
