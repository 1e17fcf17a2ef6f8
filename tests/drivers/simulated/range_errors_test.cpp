#include "drivers/simulated/range_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ariadne::drivers {
namespace {

SystematicError SystematicErrorOf(const RangeFinderOptions& options, std::uint64_t seed) {
  return SystematicError(options, NamedStream(seed, "range_errors_test"));
}

TEST(RangeMode, EndsBelowTheErrorCodesOfTheDevice) {
  EXPECT_DOUBLE_EQ(MaxRange(RangeMode::kMm8m), 8.182);
  EXPECT_DOUBLE_EQ(MaxRange(RangeMode::kCm80m), 81.82);
  EXPECT_DOUBLE_EQ(MaxRange(RangeMode::kMm16m), 16.374);
  EXPECT_DOUBLE_EQ(MaxRange(RangeMode::kMm32m), 32.758);
}

TEST(ReportedRange, IsAMultipleOfTheUnit) {
  RangeFinderOptions options;
  EXPECT_FLOAT_EQ(ReportedRange(3.1449, options), 3.14F);
  options.mode = RangeMode::kMm8m;
  EXPECT_FLOAT_EQ(ReportedRange(3.1449, options), 3.145F);
  options.quantize = false;
  EXPECT_FLOAT_EQ(ReportedRange(3.1449, options), 3.1449F);
}

TEST(ReportedRange, IsNoReturnOutsideOfTheMode) {
  RangeFinderOptions options;
  options.mode = RangeMode::kMm8m;
  EXPECT_FLOAT_EQ(ReportedRange(8.182, options), 8.182F) << "the largest value";
  EXPECT_TRUE(std::isnan(ReportedRange(8.183, options)));
  EXPECT_TRUE(std::isnan(ReportedRange(-0.01, options)));
  EXPECT_TRUE(std::isnan(ReportedRange(0.0004, options))) << "rounded to nothing";
  options.quantize = false;
  EXPECT_TRUE(std::isnan(ReportedRange(8.183, options))) << "the mode ends, rounded or not";
}

TEST(ReportedReflectance, HasTheLevelsOfTheDevice) {
  EXPECT_FLOAT_EQ(ReportedReflectance(0.5, ReflectanceOutput::k3Bit), 4.0F / 7.0F);
  EXPECT_FLOAT_EQ(ReportedReflectance(0.5, ReflectanceOutput::k8Bit), 128.0F / 255.0F);
  EXPECT_FLOAT_EQ(ReportedReflectance(0.3, ReflectanceOutput::kExact), 0.3F);
  EXPECT_FLOAT_EQ(ReportedReflectance(7.0, ReflectanceOutput::k8Bit), 1.0F) << "saturates";
}

TEST(SystematicError, StaysWithinItsLimitAndIsSmooth) {
  const RangeFinderOptions options;
  double largest = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SystematicError error = SystematicErrorOf(options, seed);
    for (double range = 0.0; range < 90.0; range += 0.01) {
      largest = std::max(largest, std::abs(error.At(range)));
      EXPECT_LT(std::abs(error.At(range + 0.01) - error.At(range)), 3e-4) << "at " << range;
    }
  }
  EXPECT_LE(largest, options.systematic_limit);
  EXPECT_GT(largest, 0.9 * options.systematic_limit) << "and makes use of it";
}

TEST(SystematicError, IsConstantIfAsked) {
  RangeFinderOptions options;
  options.systematic_shape = SystematicShape::kConstant;
  const SystematicError error = SystematicErrorOf(options, 3);
  EXPECT_NE(error.At(1.0), 0.0);
  EXPECT_EQ(error.At(1.0), error.At(50.0));
}

TEST(SystematicError, BelongsToTheDeviceAndCanBeSwitchedOff) {
  RangeFinderOptions options;
  EXPECT_EQ(SystematicErrorOf(options, 3).At(5.0), SystematicErrorOf(options, 3).At(5.0));
  EXPECT_NE(SystematicErrorOf(options, 3).At(5.0), SystematicErrorOf(options, 4).At(5.0));
  options.systematic = false;
  EXPECT_EQ(SystematicErrorOf(options, 3).At(5.0), 0.0);
}

TEST(SystematicError, IsUniformOverDevices) {
  RangeFinderOptions options;
  options.systematic_shape = SystematicShape::kConstant;
  double sum = 0.0, squares = 0.0;
  constexpr int kDevices = 2000;
  for (std::uint64_t seed = 0; seed < kDevices; ++seed) {
    const double e = SystematicErrorOf(options, seed).At(1.0) / options.systematic_limit;
    sum += e;
    squares += e * e;
  }
  EXPECT_NEAR(sum / kDevices, 0.0, 4.0 * std::sqrt(1.0 / 3.0 / kDevices));
  EXPECT_NEAR(squares / kDevices, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / kDevices));
}

}  // namespace
}  // namespace ariadne::drivers
