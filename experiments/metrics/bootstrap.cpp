#include "experiments/metrics/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "experiments/metrics/statistics.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

/// The statistic of the sample that has the values with these indices.
using IndexStatistic = std::function<double(std::span<const std::size_t>)>;

const boost::math::normal kNormal;

std::vector<double> SortedReplicates(std::size_t count, const IndexStatistic& statistic,
                                     const BootstrapOptions& options) {
  RandomStream stream = NamedStream(options.seed, "metrics/bootstrap");
  std::vector<double> replicates(static_cast<std::size_t>(options.resamples));
  std::vector<std::size_t> drawn(count);
  for (double& replicate : replicates) {
    for (std::size_t& index : drawn)
      index = static_cast<std::size_t>(DrawUniform(stream, 0.0, static_cast<double>(count)));
    replicate = statistic(drawn);
  }
  std::sort(replicates.begin(), replicates.end());
  return replicates;
}

/// a: how fast the statistic's standard deviation changes with its value. Zero without spread.
double Acceleration(std::size_t count, const IndexStatistic& statistic) {
  if (count < 2) return 0.0;
  std::vector<std::size_t> others(count - 1);
  std::vector<double> jackknife;
  for (std::size_t left_out = 0; left_out < count; ++left_out) {
    for (std::size_t k = 0; k < others.size(); ++k) others[k] = k < left_out ? k : k + 1;
    jackknife.push_back(statistic(others));
  }
  const double mean = Mean(jackknife);
  double squares = 0.0, cubes = 0.0;
  for (const double value : jackknife) {
    squares += std::pow(mean - value, 2);
    cubes += std::pow(mean - value, 3);
  }
  return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

/// z0: how far the estimate is from the median of its replicates, in standard deviations.
double BiasCorrection(const std::vector<double>& sorted, double estimate) {
  const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), estimate);
  const double below =
      static_cast<double>(first - sorted.begin()) + 0.5 * static_cast<double>(last - first);
  const auto count = static_cast<double>(sorted.size());
  return boost::math::quantile(kNormal, std::clamp(below, 0.5, count - 0.5) / count);
}

Interval Resample(std::size_t count, const IndexStatistic& statistic, const BootstrapOptions& options) {
  CheckOptions(options, "bootstrap.");
  if (count == 0) Fail("there are no values to bootstrap");
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double estimate = statistic(all);
  const std::vector<double> sorted = SortedReplicates(count, statistic, options);
  const double tail = 0.5 * (1.0 - options.confidence);
  if (options.method == BootstrapMethod::kPercentile)
    return {estimate, QuantileOfSorted(sorted, tail), QuantileOfSorted(sorted, 1.0 - tail)};
  const double z0 = BiasCorrection(sorted, estimate);
  const double a = Acceleration(count, statistic);
  const auto end_of = [&](double share) {
    const double shifted = z0 + boost::math::quantile(kNormal, share);
    const double corrected = boost::math::cdf(kNormal, z0 + shifted / (1.0 - a * shifted));
    return QuantileOfSorted(sorted, corrected);
  };
  return {estimate, end_of(tail), end_of(1.0 - tail)};
}

std::vector<double> Picked(std::span<const double> values, std::span<const std::size_t> indices) {
  std::vector<double> picked;
  picked.reserve(indices.size());
  for (const std::size_t i : indices) picked.push_back(values[i]);
  return picked;
}

void RequirePairs(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) Fail("{} values cannot be paired with {}", a.size(), b.size());
}

}  // namespace

double MedianStatistic(std::span<const double> values) {
  return Median(std::vector<double>(values.begin(), values.end()));
}

Interval BootstrapInterval(std::span<const double> values, const Statistic& statistic,
                           const BootstrapOptions& options) {
  const auto of_indices = [&](std::span<const std::size_t> i) { return statistic(Picked(values, i)); };
  return Resample(values.size(), of_indices, options);
}

Interval BootstrapDifference(std::span<const double> a, std::span<const double> b,
                             const Statistic& statistic, const BootstrapOptions& options) {
  RequirePairs(a, b);
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return BootstrapInterval(differences, statistic, options);
}

Interval BootstrapRatio(std::span<const double> a, std::span<const double> b, const Statistic& statistic,
                        const BootstrapOptions& options) {
  RequirePairs(a, b);
  const auto of_indices = [&](std::span<const std::size_t> i) {
    return statistic(Picked(a, i)) / statistic(Picked(b, i));
  };
  return Resample(a.size(), of_indices, options);
}

}  // namespace ariadne::experiments
