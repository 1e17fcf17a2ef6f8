#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "slam/base/options.h"

namespace ariadne::experiments {

/// How an interval is read off the replicates theta* of the statistic (Efron and Tibshirani, An
/// Introduction to the Bootstrap, 1993).
enum class BootstrapMethod {
  kPercentile,  // their alpha/2 and 1 - alpha/2 quantiles (chapter 13)
  kBca,         // the same quantiles shifted for bias and skewness (chapter 14)
};

struct BootstrapOptions {
  BootstrapMethod method = BootstrapMethod::kPercentile;
  double confidence = 0.95;
  int resamples = 10000;
  std::uint64_t seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method, "percentile holds for medians too; bca is more accurate for means");
    visit("confidence", self.confidence, Unit("share"), Range{0.5, 0.999}, "of the interval");
    visit("resamples", self.resamples, Unit("samples"), Range{100, 1e7},
          "the ends of the interval then move by some 2 % of its length from seed to seed");
    visit("seed", self.seed, Unit(""), Range{0, 9e15}, "of the resampling");
  }
};

/// A statistic of the whole sample, and where it may lie.
struct Interval {
  double estimate = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// What is estimated of a sample: Mean, a median, ...
using Statistic = std::function<double(std::span<const double>)>;

double MedianStatistic(std::span<const double> values);

/// Confidence interval of a statistic of values that were drawn independently, for instance one per seed.
///
/// Each replicate is the statistic of n values drawn with replacement. BCa reads the quantiles
///   Phi(z0 + (z0 + z) / (1 - a (z0 + z))) for z = Phi^-1(alpha/2), Phi^-1(1 - alpha/2), where
///   z0 = Phi^-1(share of replicates below the estimate, those equal to it counted half),
///   a = sum d_i^3 / (6 (sum d_i^2)^(3/2)), d_i = mean of the jackknife values - jackknife value i.
Interval BootstrapInterval(std::span<const double> values, const Statistic& statistic,
                           const BootstrapOptions& options);

/// Of the statistic of the differences a_i - b_i of pairs, for instance two methods on the same seed.
Interval BootstrapDifference(std::span<const double> a, std::span<const double> b,
                             const Statistic& statistic, const BootstrapOptions& options);

/// Of statistic(a) / statistic(b), where a_i and b_i are pairs: both are drawn with the same indices.
Interval BootstrapRatio(std::span<const double> a, std::span<const double> b, const Statistic& statistic,
                        const BootstrapOptions& options);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::BootstrapMethod> {
  static constexpr std::array<std::string_view, 2> value{"percentile", "bca"};
};

}  // namespace ariadne
