#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "planning/view/looked_at.h"
#include "planning/view/ray_gain.h"
#include "planning/view/sliding_window.h"
#include "slam/base/random.h"
#include "tests/planning/view/simple_room.h"

namespace ariadne::planning {
namespace {

/// The sum about a middle, in steps, by definition.
int SumAbout(double middle, std::span<const int> values, int width, std::span<const double> reaches) {
  const auto n = static_cast<double>(values.size());
  int sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = std::abs(std::remainder(static_cast<double>(i) - middle, n));
    if (off <= std::min(reaches[i], 0.5 * (width - 1)) + 1e-9) sum += values[i];
  }
  return sum;
}

TEST(BestWindowWithReaches, IsTheLargestSumByDefinition) {
  RandomStream stream = NamedStream(5, "ahead_test");
  for (int round = 0; round < 2000; ++round) {
    const int n = 5 + static_cast<int>(DrawUniform(stream, 0.0, 30.0));
    const int width = 1 + static_cast<int>(DrawUniform(stream, 0.0, n - 1.0));
    std::vector<int> values;
    std::vector<double> reaches;
    for (int i = 0; i < n; ++i) {
      values.push_back(static_cast<int>(DrawUniform(stream, 0.0, 4.0)));
      reaches.push_back(DrawUniform(stream, -2.0, 0.7 * n) + 0.25);
    }
    int largest = 0;
    for (int first = 0; first < n; ++first)
      largest = std::max(largest, SumAbout(first + 0.5 * (width - 1), values, width, reaches));
    const Window best = BestWindow(values, width, reaches);
    EXPECT_EQ(best.sum, largest) << "round " << round;
  }
}

TEST(BestWindowWithReaches, AreTheWindowsWithoutWhereTheyReachAllOfThem) {
  RandomStream stream = NamedStream(6, "ahead_test");
  std::vector<int> values(360);
  for (int& value : values) value = static_cast<int>(DrawUniform(stream, 0.0, 2.0));
  const std::vector<double> far(values.size(), 1e9);
  const Window with = BestWindow(values, 181, far), without = BestWindow(values, 181);
  EXPECT_EQ(with.sum, without.sum);
  EXPECT_EQ(with.center, without.center);
}

/// The rays that meet an unseen edge in range, far enough ahead of the line across a direction.
int CountAhead(const RayGain& gain, const Eigen::Vector2d& p, double direction, double ahead) {
  const std::vector<RayHit> hits = gain.Cast(p);
  int count = 0;
  for (const std::size_t i : gain.RaysAbout(direction)) {
    const double forward = hits[i].distance * (std::cos(direction) * gain.Direction(i).x() +
                                               std::sin(direction) * gain.Direction(i).y());
    if (gain.IsUnseen(hits[i]) && forward >= ahead) ++count;
  }
  return count;
}

TEST(Ahead, OnlyWhatLiesSoFarAheadCounts) {
  const std::vector<Edge> edges = EdgesOf(Hall(), false);
  RayGainOptions options;
  options.ahead = 0.9;
  const RayGain gain(edges, 0.3, options);
  RandomStream stream = NamedStream(7, "ahead_test");
  int fewer = 0;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector2d p(DrawUniform(stream, 0.5, 3.5), DrawUniform(stream, 1.0, 11.0));
    const ViewGain best = gain.At(p);
    EXPECT_NEAR(best.gain, CountAhead(gain, p, best.direction, 0.9), 1) << "between two rays";
    for (int k = 0; k < 360; ++k)
      ASSERT_GE(best.gain, CountAhead(gain, p, 0.3 + k * std::numbers::pi / 180.0, 0.9)) << p.transpose();
    if (best.gain < CountAhead(gain, p, best.direction, 0.0)) ++fewer;
  }
  EXPECT_GT(fewer, 100) << "the walls beside the scanner";
}

TEST(Ahead, WhoHasSeenAWallBesideItselfHasNotLookedAtIt) {
  const std::vector<Edge> wall{{{10.0, 0.5}, {-10.0, 0.5}, false}};
  const std::array<slam::Pose2, 1> along{slam::Pose2{0.0, {0.0, 0.0}}};
  RayGainOptions options;
  options.min_range = 0.0;
  const auto is_worth = [&](double ahead) {
    options.ahead = ahead;
    const LookedAt looked_at(wall, along, options, 0.25);
    const RayHit hit{0.5, false, false, 0, 100.0};
    return looked_at.IsWorth({0.3, 0.0}, {0.0, 1.0}, hit, 0.7);
  };
  EXPECT_FALSE(is_worth(0.0));
  EXPECT_TRUE(is_worth(0.9)) << "0.3 m ahead";
}

}  // namespace
}  // namespace ariadne::planning
