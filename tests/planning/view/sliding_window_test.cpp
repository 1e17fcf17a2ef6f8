#include "planning/view/sliding_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "slam/base/random.h"

namespace ariadne::planning {
namespace {

TEST(SlidingWindow, IsTheBestOfAllWindows) {
  RandomStream stream = NamedStream(9, "sliding_window");
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 1 + static_cast<int>(stream() % 24), width = 1 + static_cast<int>(stream() % 24);
    std::vector<int> values;
    for (int i = 0; i < n; ++i) values.push_back(stream() % 3 == 0 ? 1 : 0);
    const auto sum_from = [&](int first) {
      int sum = 0;
      for (int k = 0; k < std::min(n, width); ++k) sum += values[static_cast<std::size_t>((first + k) % n)];
      return sum;
    };
    int largest = 0;
    for (int first = 0; first < n; ++first) largest = std::max(largest, sum_from(first));
    const Window best = BestWindow(values, width);
    EXPECT_EQ(best.sum, largest);
    // The window about the centre, or the two that are nearest to it, are best ones.
    const double first = best.center - 0.5 * (std::min(n, width) - 1) + 2.0 * n;
    if (std::min(n, width) < n) {
      EXPECT_EQ(sum_from(static_cast<int>(std::floor(first))), largest);
      EXPECT_EQ(sum_from(static_cast<int>(std::ceil(first))), largest);
    }
  }
}

TEST(SlidingWindow, IsTheBestOfThoseWithEnoughMarks) {
  RandomStream stream = NamedStream(10, "sliding_window");
  int found = 0, none = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 1 + static_cast<int>(stream() % 24), width = 1 + static_cast<int>(stream() % 24);
    std::vector<int> values, marks;
    for (int i = 0; i < n; ++i) {
      values.push_back(static_cast<int>(stream() % 4));
      marks.push_back(static_cast<int>(stream() % 2));
    }
    const double least = DrawUniform(stream, 0.0, 1.0);
    const int wide = std::min(n, width);
    const auto sum_from = [&](const std::vector<int>& of, int first) {
      int sum = 0;
      for (int k = 0; k < wide; ++k) sum += of[static_cast<std::size_t>((first + k) % n)];
      return sum;
    };
    int largest = -1;
    for (int first = 0; first < n; ++first) {
      if (sum_from(marks, first) >= least * wide) largest = std::max(largest, sum_from(values, first));
    }
    const std::optional<Window> best = BestWindowWith(values, width, marks, least);
    ASSERT_EQ(best.has_value(), largest >= 0);
    ++(best ? found : none);
    if (!best) continue;
    EXPECT_EQ(best->sum, largest);
    const double first = best->center - 0.5 * (wide - 1) + 2.0 * n;  // of one window, not between two
    ASSERT_EQ(first, std::floor(first));
    EXPECT_EQ(sum_from(values, static_cast<int>(first)), largest);
    EXPECT_GE(sum_from(marks, static_cast<int>(first)), least * wide - 1e-9);
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(none, 200);
}

TEST(SlidingWindow, TakesTheCentreOfThePlateau) {
  std::vector<int> values(12, 0);
  values[1] = values[2] = 1;
  EXPECT_DOUBLE_EQ(BestWindow(values, 4).center, 1.5) << "windows from 11 to 1 hold both";
  EXPECT_DOUBLE_EQ(BestWindow(values, 2).center, 1.5);
  values.assign(12, 0);
  values[11] = values[0] = 1;
  EXPECT_DOUBLE_EQ(BestWindow(values, 5).center, -0.5) << "across the seam";
  values.assign(12, 0);
  values[3] = values[9] = 1;
  EXPECT_DOUBLE_EQ(BestWindow(values, 3).center, 3.0) << "of equal ones the left";
  EXPECT_DOUBLE_EQ(BestWindow(std::vector<int>(12, 0), 3).center, 0.0);
  EXPECT_EQ(BestWindow(std::vector<int>(12, 1), 99).sum, 12);
}

}  // namespace
}  // namespace ariadne::planning
