#include "planning/view/sliding_window.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ariadne::planning {
namespace {

/// Windows next to each other, by where they begin.
struct Plateau {
  int first = 0;
  int length = 0;
};

std::vector<int> WindowSums(std::span<const int> values, std::size_t width) {
  std::vector<int> sums(values.size());
  int sum = std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width), 0);
  for (std::size_t first = 0; first < values.size(); ++first) {
    sums[first] = sum;
    sum += values[(first + width) % values.size()] - values[first];
  }
  return sums;
}

/// All runs of the largest sum around the circle; empty where all sums are the same.
std::vector<Plateau> Plateaus(const std::vector<int>& sums, int largest) {
  std::vector<Plateau> plateaus;
  const auto lower = std::ranges::find_if(sums, [&](int sum) { return sum != largest; });
  if (lower == sums.end()) return plateaus;
  const auto n = static_cast<int>(sums.size()), begin = static_cast<int>(lower - sums.begin());
  bool inside = false;
  for (int i = begin; i < begin + n; ++i) {  // begins off any plateau, so that none is cut in two
    const bool is_largest = sums[static_cast<std::size_t>(i % n)] == largest;
    if (is_largest && !inside) plateaus.push_back({i, 0});
    if (is_largest) ++plateaus.back().length;
    inside = is_largest;
  }
  return plateaus;
}

/// In (-n/2, n/2].
double WrapSteps(double steps, int n) {
  const double wrapped = std::remainder(steps, n);
  return wrapped <= -0.5 * n ? 0.5 * n : wrapped;
}

/// The centre of the longest plateau of `largest`, the middle of which may lie between two windows.
double BestCenter(const std::vector<int>& sums, int largest, int width, bool between) {
  const auto n = static_cast<int>(sums.size());
  const int odd_gap = (width - 1) % 2;  // 1: the middle of a window lies between two values
  double best = between ? 0.0 : 0.5 * odd_gap;
  int longest = 0;
  for (const auto& [first, length] : Plateaus(sums, largest)) {
    const int first_middle = (length - 1) / 2;
    const double middle = between ? 0.5 * (length - 1) : first_middle;
    const double center = WrapSteps(first + middle + 0.5 * (width - 1), n);
    const double turn = std::abs(center), best_turn = std::abs(best);
    const bool is_nearer = turn < best_turn || (turn == best_turn && center > best);
    if (length > longest || (length == longest && is_nearer)) best = center, longest = length;
  }
  return best;
}

}  // namespace

Window BestWindow(std::span<const int> values, int width) {
  width = std::clamp(width, 1, static_cast<int>(values.size()));
  const std::vector<int> sums = WindowSums(values, static_cast<std::size_t>(width));
  const int largest = *std::ranges::max_element(sums);
  return {largest, BestCenter(sums, largest, width, true)};
}

std::optional<Window> BestWindowWith(std::span<const int> values, int width, std::span<const int> marks,
                                     double least_share) {
  width = std::clamp(width, 1, static_cast<int>(values.size()));
  std::vector<int> sums = WindowSums(values, static_cast<std::size_t>(width));
  const std::vector<int> marked = WindowSums(marks, static_cast<std::size_t>(width));
  constexpr int kRefused = -1;  // less than any sum
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (static_cast<double>(marked[i]) / width < least_share) sums[i] = kRefused;
  }
  const int largest = *std::ranges::max_element(sums);
  if (largest == kRefused) return {};
  return Window{largest, BestCenter(sums, largest, width, false)};
}

}  // namespace ariadne::planning
