#include "slam/graph/kernels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

constexpr double kSquaredScale = 2.5;

struct KernelFacts {
  GraphRobust kernel;
  double slope_at_scale;  // the weight of an edge whose squared error is the scale
  double limit;           // of rho, in squared scales
};

class Kernel : public testing::TestWithParam<KernelFacts> {
 protected:
  static KernelValue At(double squared_error) {
    return Evaluate(GetParam().kernel, squared_error, kSquaredScale);
  }
};
constexpr double kInfinity = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(Kernels, Kernel,
                         testing::Values(KernelFacts{GraphRobust::kNone, 1.0, kInfinity},
                                         KernelFacts{GraphRobust::kHuber, 1.0, kInfinity},
                                         KernelFacts{GraphRobust::kCauchy, 0.5, kInfinity},
                                         KernelFacts{GraphRobust::kGemanMcClure, 0.25, 1.0},
                                         KernelFacts{GraphRobust::kSwitchable, 0.25, 1.0},
                                         KernelFacts{GraphRobust::kDcs, 1.0, 3.0},
                                         KernelFacts{GraphRobust::kGnc, 1.0, 1.0}),
                         [](const auto& facts) { return std::string(NameOf(facts.param.kernel)); });

TEST_P(Kernel, LeavesNoErrorAlone) {
  EXPECT_EQ(At(0.0).value, 0.0);
  EXPECT_EQ(At(0.0).slope, 1.0);
  EXPECT_NEAR(At(1e-9).value, 1e-9, 1e-17);
}

TEST_P(Kernel, HasTheDerivativesOfItsValues) {
  for (const double scales : {0.1, 0.5, 0.9, 0.9999, 1.0001, 1.1, 2.0, 10.0, 1000.0}) {
    const double s = scales * kSquaredScale;
    const double step = 1e-6 * s;
    const double slope = (At(s + step).value - At(s - step).value) / (2.0 * step);
    const double curvature = (At(s + step).slope - At(s - step).slope) / (2.0 * step);
    EXPECT_NEAR(At(s).slope, slope, 1e-7) << scales;
    EXPECT_NEAR(At(s).curvature, curvature, 1e-7) << scales;
  }
}

TEST_P(Kernel, GrowsAndDoubtsMoreTheLargerTheError) {
  KernelValue before = At(0.0);
  for (double s = 0.01; s < 1e6; s *= 1.07) {
    const KernelValue now = At(s);
    EXPECT_GE(now.value, before.value);
    EXPECT_LE(now.value, s);
    EXPECT_LE(now.slope, before.slope);
    EXPECT_GE(now.slope, 0.0);
    EXPECT_LE(now.curvature, 0.0);
    before = now;
  }
}

TEST_P(Kernel, HasTheTextbookWeightAndLimit) {
  EXPECT_NEAR(At(kSquaredScale).slope, GetParam().slope_at_scale, 1e-15);
  const double far = At(1e14).value;
  if (GetParam().limit < kInfinity)
    EXPECT_NEAR(far, GetParam().limit * kSquaredScale, 1e-9);
  else
    EXPECT_GT(far, 70.0);
}

TEST_P(Kernel, IsContinuousWhereItBeginsToDoubt) {
  EXPECT_NEAR(At(kSquaredScale * (1.0 - 1e-12)).value, At(kSquaredScale * (1.0 + 1e-12)).value, 1e-11);
}

TEST(SwitchableKernel, IsTheBestThatTheSwitchCanDo) {
  for (const double s : {0.0, 0.3, 2.0, 40.0}) {
    double least = kInfinity;
    for (double x = 0.0; x <= 1.0; x += 1e-4)
      least = std::min(least, x * x * s + kSquaredScale * (1.0 - x) * (1.0 - x));
    EXPECT_NEAR(Evaluate(GraphRobust::kSwitchable, s, kSquaredScale).value, least, 1e-6);
  }
}

TEST(DcsKernel, HasAgarwalsScaleSquaredForItsWeight) {
  for (const double s : {0.1, 2.0, 2.6, 9.0, 500.0}) {
    const double scale = std::min(1.0, 2.0 * kSquaredScale / (kSquaredScale + s));
    EXPECT_NEAR(Evaluate(GraphRobust::kDcs, s, kSquaredScale).slope, scale * scale, 1e-15);
  }
}

TEST(SquaredScale, IsTheQuantileOfTheTables) {
  EXPECT_NEAR(SquaredScale(0.95, 3), 7.8147, 1e-4);
  EXPECT_NEAR(SquaredScale(0.99, 6), 16.8119, 1e-4);
  EXPECT_THAT(ErrorOf([] { SquaredScale(1.0, 3); }), testing::HasSubstr("no chi-square quantile of 1"));
}

}  // namespace
}  // namespace ariadne::slam
