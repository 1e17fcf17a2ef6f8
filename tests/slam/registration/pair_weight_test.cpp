#include "slam/registration/pair_weight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "slam/base/random.h"

namespace ariadne::slam {
namespace {

constexpr double kScale = 0.2;  // [m]

struct KernelValues {
  RobustKernel kernel;
  double at_half, at_one, at_two;  // scales
};

class PairWeightOf : public testing::TestWithParam<KernelValues> {
 protected:
  const PairWeight weight_ = ChooseWeight({}, 1.0, GetParam().kernel, kScale);
};
INSTANTIATE_TEST_SUITE_P(Kernels, PairWeightOf,
                         testing::Values(KernelValues{RobustKernel::kNone, 1.0, 1.0, 1.0},
                                         KernelValues{RobustKernel::kHuber, 1.0, 1.0, 0.5},
                                         KernelValues{RobustKernel::kCauchy, 0.8, 0.5, 0.2},
                                         KernelValues{RobustKernel::kTukey, 0.5625, 0.0, 0.0},
                                         KernelValues{RobustKernel::kGemanMcClure, 0.64, 0.25, 0.04}),
                         [](const auto& values) {
                           return std::string(ariadne::NameOf(values.param.kernel));
                         });

TEST_P(PairWeightOf, HasTheTextbookValues) {
  const auto at = [&](double scales) { return weight_(std::pow(scales * kScale, 2)); };
  EXPECT_DOUBLE_EQ(at(0.0), 1.0);
  EXPECT_NEAR(at(0.5), GetParam().at_half, 1e-14);
  EXPECT_NEAR(at(1.0), GetParam().at_one, 1e-14);
  EXPECT_NEAR(at(2.0), GetParam().at_two, 1e-14);
}

TEST_P(PairWeightOf, HasTheDerivativeOfItsValues) {
  for (const double scales : {0.0, 0.1, 0.5, 0.9, 1.1, 2.0, 5.0}) {
    const double squared = std::pow(scales * kScale, 2);
    const double step = 1e-6 * kScale * kScale;
    const double difference = (weight_(squared + step) - weight_(squared - step)) / (2.0 * step);
    EXPECT_NEAR(weight_.Derivative(squared), difference, 1e-6 / (kScale * kScale)) << scales;
  }
}

TEST_P(PairWeightOf, IsZeroBeyondTheTrimmedShare) {
  const PairWeight weight = ChooseWeight({0.01, 0.04, 0.09, 0.16}, 0.5, GetParam().kernel, 10.0);
  EXPECT_GT(weight(0.04), 0.0);
  EXPECT_EQ(weight(0.16), 0.0);
  EXPECT_EQ(weight.Derivative(0.16), 0.0);
}

TEST(ChooseWeight, TrimsToTheShareWithTheSmallestResiduals) {
  RandomStream stream = NamedStream(1, "pair_weight_test/trim");
  std::vector<double> squared(501);
  for (double& x : squared) x = DrawUniform(stream, 0.0, 1.0);
  for (const double trim : {0.05, 0.3, 0.5, 0.8, 0.99}) {
    const PairWeight weight = ChooseWeight(squared, trim, RobustKernel::kNone, 0.0);
    double kept = 0.0, largest_kept = 0.0, smallest_dropped = 1.0;
    for (const double x : squared) {
      kept += weight(x);
      (weight(x) > 0.0 ? largest_kept : smallest_dropped) =
          weight(x) > 0.0 ? std::max(largest_kept, x) : std::min(smallest_dropped, x);
    }
    EXPECT_NEAR(kept, trim * 501.0, 1.0);
    EXPECT_LT(largest_kept, smallest_dropped);
  }
}

TEST(ChooseWeight, KeepsAllPairsWithoutTrimming) {
  EXPECT_EQ(ChooseWeight({1.0, 2.0, 1e9}, 1.0, RobustKernel::kNone, 0.0)(1e9), 1.0);
  EXPECT_EQ(ChooseWeight({4.0, 4.0, 4.0}, 0.5, RobustKernel::kNone, 0.0)(4.0), 1.0) << "ties stay";
}

TEST(ChooseWeight, TakesThreeRobustSigmasForTheScale) {
  RandomStream stream = NamedStream(1, "pair_weight_test/scale");
  std::vector<double> squared(2000);
  for (std::size_t i = 0; i < squared.size(); ++i) {
    const double sigma = i % 5 == 0 ? 5.0 : 0.02;  // a fifth are outliers
    squared[i] = std::pow(DrawNormal(stream, 0.0, sigma), 2);
  }
  const PairWeight weight = ChooseWeight(squared, 1.0, RobustKernel::kTukey, 0.0);
  EXPECT_GT(std::sqrt(weight.squared_scale), 3.0 * 0.02);
  EXPECT_LT(std::sqrt(weight.squared_scale), 1.5 * 3.0 * 0.02);
}

TEST(ChooseWeight, TakesTheScaleThatIsGiven) {
  EXPECT_DOUBLE_EQ(ChooseWeight({1.0, 2.0}, 1.0, RobustKernel::kHuber, 0.3).squared_scale, 0.09);
}

TEST(ChooseWeight, StaysDefinedWhereAllResidualsAreZero) {
  const PairWeight weight = ChooseWeight({0.0, 0.0, 0.0}, 1.0, RobustKernel::kCauchy, 0.0);
  EXPECT_EQ(weight(0.0), 1.0);
  EXPECT_LT(weight(1e-6), 1e-5);
}

}  // namespace
}  // namespace ariadne::slam
