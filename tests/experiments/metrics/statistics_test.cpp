#include "experiments/metrics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

TEST(Quantile, InterpolatesLikeNumPy) {
  const std::vector<double> values{40.0, 10.0, 30.0, 20.0};  // numpy.quantile([10, 20, 30, 40], p)
  EXPECT_DOUBLE_EQ(Quantile(values, 0.0), 10.0);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.25), 17.5);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.5), 25.0);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.95), 38.5);
  EXPECT_DOUBLE_EQ(Quantile(values, 1.0), 40.0);
}

TEST(Quantile, OfOneValueIsThatValue) { EXPECT_EQ(Quantile({7.0}, 0.3), 7.0); }

TEST(Quantile, WantsValuesAndAShare) {
  EXPECT_THROW(Quantile({}, 0.5), Error);
  EXPECT_THROW(Quantile({1.0}, 1.1), Error);
  EXPECT_THROW(Quantile({1.0}, std::nan("")), Error);
  EXPECT_THROW(Mean({}), Error);
}

TEST(Median, IsTheMiddleOne) {
  EXPECT_EQ(Median({9.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(Median({9.0, 1.0, 2.0, 4.0}), 3.0);
}

TEST(Summarize, HasTheStatisticsOfEvo) {
  const Summary s = Summarize({1.0, 2.0, 3.0, 6.0});
  EXPECT_EQ(s.count, 4u);
  EXPECT_DOUBLE_EQ(s.rms, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(s.mean, 3.0);
  EXPECT_DOUBLE_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.standard_deviation, std::sqrt(3.5));  // of the population, as numpy.std
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.max, 6.0);
}

TEST(Summarize, OfNothingCountsNothing) {
  EXPECT_EQ(Summarize({}).count, 0u);
  EXPECT_EQ(Summarize({}).rms, 0.0);
}

}  // namespace
}  // namespace ariadne::experiments
