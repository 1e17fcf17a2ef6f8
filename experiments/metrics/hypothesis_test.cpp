#include "experiments/metrics/hypothesis_test.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kMostExact = 50;  // 2^50 choices of signs fit in a double's 53 bits

/// Twice the ranks, which makes those of ties whole numbers, in ascending order; and sum (t^3 - t).
struct DoubledRanks {
  std::vector<std::size_t> ranks;
  double tie_sum = 0.0;
};

DoubledRanks RankSorted(const std::vector<double>& by_magnitude) {
  DoubledRanks result;
  for (std::size_t begin = 0; begin < by_magnitude.size();) {
    std::size_t end = begin;
    while (end < by_magnitude.size() && std::abs(by_magnitude[end]) == std::abs(by_magnitude[begin])) ++end;
    const auto ties = static_cast<double>(end - begin);
    result.ranks.insert(result.ranks.end(), end - begin, begin + 1 + end);  // (begin + 1 .. end), mean x 2
    result.tie_sum += ties * ties * ties - ties;
    begin = end;
  }
  return result;
}

/// P(sum of the ranks with positive sign <= w) if all signs are equally likely; all in doubled ranks.
double ExactLowerTail(const std::vector<std::size_t>& ranks, std::size_t w) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  std::vector<double> choices(total + 1, 0.0);  // choices[s]: ways to choose signs so that the sum is s
  choices[0] = 1.0;
  for (const std::size_t rank : ranks) {
    for (std::size_t sum = total; sum >= rank; --sum) choices[sum] += choices[sum - rank];
  }
  const auto end = choices.begin() + static_cast<std::ptrdiff_t>(w + 1);
  return std::ldexp(std::accumulate(choices.begin(), end, 0.0), -static_cast<int>(ranks.size()));
}

double NormalLowerTail(double count, double w, double tie_sum) {
  const double mean = count * (count + 1.0) / 4.0;
  const double variance = count * (count + 1.0) * (2.0 * count + 1.0) / 24.0 - tie_sum / 48.0;
  return boost::math::cdf(boost::math::normal(), (w - mean + 0.5) / std::sqrt(variance));
}

}  // namespace

SignedRankTest TestSignedRank(std::span<const double> differences, std::size_t max_exact) {
  std::vector<double> sorted;
  for (const double d : differences) {
    if (!std::isfinite(d)) Fail("a difference of {} has no rank", d);
    if (d != 0.0) sorted.push_back(d);
  }
  std::sort(sorted.begin(), sorted.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const DoubledRanks ranked = RankSorted(sorted);
  std::size_t positive = 0, negative = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    (sorted[i] > 0.0 ? positive : negative) += ranked.ranks[i];
  const std::size_t w = std::min(positive, negative);

  SignedRankTest test{sorted.size(), 0.5 * static_cast<double>(positive),
                      0.5 * static_cast<double>(negative)};
  test.exact = sorted.size() <= std::min(max_exact, kMostExact);
  const double tail = test.exact ? ExactLowerTail(ranked.ranks, w)
                                 : NormalLowerTail(static_cast<double>(sorted.size()),
                                                   0.5 * static_cast<double>(w), ranked.tie_sum);
  test.p_two_sided = std::min(1.0, 2.0 * tail);
  return test;
}

SignedRankTest TestSignedRank(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) Fail("{} values cannot be paired with {}", a.size(), b.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return TestSignedRank(differences);
}

std::vector<double> HolmAdjusted(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return p_values[i] < p_values[j]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto remaining = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, remaining * p_values[order[i]]));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

}  // namespace ariadne::experiments
