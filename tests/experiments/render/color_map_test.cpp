#include "experiments/render/color_map.h"

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <cmath>

#include <limits>

namespace ariadne::experiments {
namespace {

/// CIELAB (D65) of an sRGB colour: L from 0 to 100, distances about as they look.
Eigen::Vector3d Lab(Rgb color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const Eigen::Vector3d rgb(linear(color.r), linear(color.g), linear(color.b));
  const Eigen::Vector3d x =
      Eigen::Matrix3d{{0.4339, 0.3762, 0.1899}, {0.2126, 0.7152, 0.0722}, {0.0178, 0.1095, 0.8727}} * rgb;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  return {116.0 * f(x[1]) - 16.0, 500.0 * (f(x[0]) - f(x[1])), 200.0 * (f(x[1]) - f(x[2]))};
}

TEST(ColorMap, LightnessOnlyRisesOrOnlyFalls) {
  for (const ColorMap map : {ColorMap::kSea, ColorMap::kShore, ColorMap::kHeat, ColorMap::kGray}) {
    const double sense = Lab(ColorAt(map, 1.0))[0] > Lab(ColorAt(map, 0.0))[0] ? 1.0 : -1.0;
    for (int i = 0; i < 16; ++i) {
      EXPECT_GT(sense * (Lab(ColorAt(map, (i + 1) / 16.0))[0] - Lab(ColorAt(map, i / 16.0))[0]), 0.5) << i;
    }
  }
}

TEST(ColorMap, StepsLookEqual) {
  for (const ColorMap map : {ColorMap::kSea, ColorMap::kShore, ColorMap::kHeat, ColorMap::kGray}) {
    double smallest = 1e9, largest = 0.0;
    for (int i = 0; i < 16; ++i) {
      const double step = (Lab(ColorAt(map, (i + 1) / 16.0)) - Lab(ColorAt(map, i / 16.0))).norm();
      smallest = std::min(smallest, step);
      largest = std::max(largest, step);
    }
    EXPECT_LT(largest, 2.5 * smallest) << static_cast<int>(map);
  }
}

TEST(ColorMap, EndsHoldBeyondTheRange) {
  EXPECT_EQ(ColorAt(ColorMap::kSea, -3.0), ColorAt(ColorMap::kSea, 0.0));
  EXPECT_EQ(ColorAt(ColorMap::kSea, 1e30), ColorAt(ColorMap::kSea, 1.0));
  EXPECT_EQ(ColorAt(ColorMap::kSea, std::numeric_limits<double>::quiet_NaN()),
            ColorAt(ColorMap::kSea, 0.0));
}

TEST(CategoricalColor, ColorsDifferFromEachOtherAndFromPaper) {
  for (std::size_t i = 0; i < kCategoricalColors; ++i) {
    EXPECT_GT((Lab(CategoricalColor(i)) - Lab(kWhite)).norm(), 35.0) << i;
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((Lab(CategoricalColor(i)) - Lab(CategoricalColor(j))).norm(), 18.0) << i << " " << j;
    }
  }
  EXPECT_EQ(CategoricalColor(kCategoricalColors + 3), CategoricalColor(3));
}

TEST(RobustRange, LeavesOutliersOut) {
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i) values.push_back(i);
  values.push_back(1e9);
  const ValueRange range = RobustRange(values, 0.01);
  EXPECT_NEAR(range.low, 10.0, 1.0);
  EXPECT_NEAR(range.high, 991.0, 1.0);
  EXPECT_EQ((ValueRange{2.0, 6.0}.Share(3.0)), 0.25);
  EXPECT_EQ((ValueRange{2.0, 2.0}.Share(2.0)), 0.5);
}

}  // namespace
}  // namespace ariadne::experiments
