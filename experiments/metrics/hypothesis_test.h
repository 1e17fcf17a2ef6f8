#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ariadne::experiments {

/// Are the differences of pairs symmetric about zero? Wilcoxon's signed-rank test.
struct SignedRankTest {
  std::size_t pairs = 0;     // that differ; those that do not are left out, as Wilcoxon does
  double positive = 0.0;     // W+: sum of the ranks of |difference| over the positive differences
  double negative = 0.0;     // W-: over the negative ones; equal |differences| share their mean rank
  double p_two_sided = 1.0;  // probability of a min(W+, W-) this low if all signs are equally likely
  bool exact = true;         // p counts all 2^pairs choices of signs; else the normal approximation
};

/// Up to `max_exact` pairs (at most 50, where counts still are exact in double precision) p is exact, with
/// ties too, because the distribution is that of the very ranks at hand; beyond, (W - n(n+1)/4 + 1/2) / s
/// is taken as normal, s^2 = n(n+1)(2n+1)/24 - sum (t^3 - t)/48 over groups of t ties.
SignedRankTest TestSignedRank(std::span<const double> differences, std::size_t max_exact = 50);
SignedRankTest TestSignedRank(std::span<const double> a, std::span<const double> b);

/// p-values adjusted for testing several hypotheses at once, in the order given: the j-th smallest of m
/// becomes max over i <= j of min(1, (m - i + 1) p_i) (Holm 1979). Reject where it is at most alpha, and
/// the probability of any false rejection is at most alpha, however the tests depend on each other.
std::vector<double> HolmAdjusted(std::span<const double> p_values);

}  // namespace ariadne::experiments
