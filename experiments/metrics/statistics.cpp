#include "experiments/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

void RequireValues(std::span<const double> values) {
  if (values.empty()) Fail("there are no values to take a statistic of");
}

}  // namespace

double Mean(std::span<const double> values) {
  RequireValues(values);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double Rms(std::span<const double> values) {
  RequireValues(values);
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double StandardDeviation(std::span<const double> values) {
  const double mean = Mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double QuantileOfSorted(std::span<const double> ascending, double p) {
  RequireValues(ascending);
  if (!(p >= 0.0 && p <= 1.0)) Fail("a quantile is asked for at {}, but must be in 0 to 1", p);
  const double position = p * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return std::lerp(ascending[below], ascending[above], position - static_cast<double>(below));
}

double Quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return QuantileOfSorted(values, p);
}

double Median(std::vector<double> values) { return Quantile(std::move(values), 0.5); }

Summary Summarize(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return {values.size(), Rms(values), Mean(values), Median(values), StandardDeviation(values), *min, *max};
}

}  // namespace ariadne::experiments
