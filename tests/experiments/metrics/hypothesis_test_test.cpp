#include "experiments/metrics/hypothesis_test.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// Heights of cross-fertilized less self-fertilized maize, in eighths of an inch: Darwin 1876, in Fisher,
/// The Design of Experiments, 1935. R's wilcox.test and SciPy give W = 24, p = 0.041259765625 exactly.
const std::vector<double> kMaize{6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75};

TEST(TestSignedRank, IsExactOnDarwinsMaize) {
  const SignedRankTest test = TestSignedRank(kMaize);
  EXPECT_TRUE(test.exact);
  EXPECT_EQ(test.pairs, 15u);
  EXPECT_EQ(test.positive, 96.0);
  EXPECT_EQ(test.negative, 24.0);
  EXPECT_DOUBLE_EQ(test.p_two_sided, 0.041259765625);
}

TEST(TestSignedRank, ApproximatesLargeSamplesByTheNormalDistribution) {
  const SignedRankTest test = TestSignedRank(kMaize, 10);
  EXPECT_FALSE(test.exact);
  EXPECT_NEAR(test.p_two_sided, 0.043772323763041174, 1e-12);  // SciPy 1.10, mode="approx", correction=True
}

TEST(TestSignedRank, CountsTiesExactly) {
  // Without the zero: ranks 1.5 1.5 4 4 4 6 8.5 8.5 7, W- = 1.5 + 4. Of the 512 choices of signs 13 have a
  // sum of at most 5.5 (enumerated).
  const std::vector<double> differences{1, -1, 2, 2, -2, 3, 0, 5, 5, 4};
  const SignedRankTest test = TestSignedRank(differences);
  EXPECT_EQ(test.pairs, 9u);
  EXPECT_EQ(test.negative, 5.5);
  EXPECT_DOUBLE_EQ(test.p_two_sided, 26.0 / 512.0);
  EXPECT_NEAR(TestSignedRank(differences, 0).p_two_sided, 0.04940018799120363, 1e-12);  // SciPy, as above
}

TEST(TestSignedRank, HasCriticalValuesAsPublished) {
  // Wilcoxon 1945: of n = 8 pairs, W = 3 is significant at 5 % on two sides and W = 4 is not.
  const auto p_of = [](double negative_rank_a, double negative_rank_b) {
    std::vector<double> differences;
    for (int rank = 1; rank <= 8; ++rank)
      differences.push_back(rank == negative_rank_a || rank == negative_rank_b ? -rank : rank);
    return TestSignedRank(differences).p_two_sided;
  };
  EXPECT_DOUBLE_EQ(p_of(1, 2), 10.0 / 256.0);
  EXPECT_DOUBLE_EQ(p_of(1, 3), 14.0 / 256.0);
}

TEST(TestSignedRank, FindsNothingWithoutDifferences) {
  EXPECT_EQ(TestSignedRank(std::vector<double>(9, 0.0)).p_two_sided, 1.0);
  EXPECT_EQ(TestSignedRank(std::vector<double>{}).p_two_sided, 1.0);
  EXPECT_EQ(TestSignedRank(std::vector<double>{1, -1}).p_two_sided, 1.0);
}

TEST(TestSignedRank, TakesPairs) {
  const std::vector<double> a{5, 7, 9}, b{4, 5, 6};
  EXPECT_DOUBLE_EQ(TestSignedRank(a, b).p_two_sided, 0.25);  // 2 / 2^3: the least that 3 pairs can give
  EXPECT_THROW(TestSignedRank(a, std::vector<double>{1.0}), Error);
  EXPECT_THROW(TestSignedRank(std::vector<double>{std::nan("")}), Error);
}

TEST(TestSignedRank, HasAnExactAndAnApproximateFormThatMeet) {
  std::vector<double> differences;
  for (int i = 1; i <= 50; ++i) differences.push_back(i % 3 == 0 ? -i : i);
  EXPECT_NEAR(TestSignedRank(differences, 50).p_two_sided, 0.02616696817119646, 1e-12);  // SciPy, exact
  EXPECT_NEAR(TestSignedRank(differences, 0).p_two_sided, 0.027063492176047897, 1e-12);  // SciPy, approx
}

TEST(HolmAdjusted, ScalesTheSmallestMostAndKeepsTheOrder) {
  const std::vector<double> adjusted = HolmAdjusted(std::vector<double>{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};  // 3 x 0.01, then 2 x 0.03 > 0.04, 4 x 0.005
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(adjusted[i], expected[i]);
}

TEST(HolmAdjusted, StaysAProbability) {
  EXPECT_EQ(HolmAdjusted(std::vector<double>{0.9, 0.8}), (std::vector<double>{1.0, 1.0}));
  EXPECT_TRUE(HolmAdjusted({}).empty());
}

}  // namespace
}  // namespace ariadne::experiments
