#include "slam/extract/length_ratio.h"

#include <gtest/gtest.h>

#include "slam/base/random.h"
#include "tests/slam/extract/lines_of_points.h"

namespace ariadne::slam {
namespace {

TEST(LengthRatio, RisesFromThreePointsToMany) {
  const LengthRatioOptions options;
  EXPECT_DOUBLE_EQ(LengthRatioThreshold(3, options), options.epsilon_three);
  for (int points = 4; points < 1000; ++points) {
    EXPECT_GT(LengthRatioThreshold(points, options), LengthRatioThreshold(points - 1, options));
  }
  EXPECT_NEAR(LengthRatioThreshold(100000, options), options.epsilon_many, 1e-5);
}

/// Points on a way that wanders, 10 cm apart.
Points Wander(std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "detect_lines/wander");
  Points points{{3.0, 0.0}};
  double heading = 1.5;
  for (int i = 0; i < 150; ++i) {
    heading += DrawNormal(stream, 0.0, 0.35);
    points.emplace_back(points.back() + 0.1 * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
  }
  return points;
}

/// Chord over path of the points first, ..., last.
double RatioOf(const Points& points, std::size_t first, std::size_t last) {
  double path = 0.0;
  for (std::size_t t = first; t < last; ++t) path += (points[t + 1] - points[t]).norm();
  return (points[last] - points[first]).norm() / path;
}

TEST(LengthRatio, IsThePapersInequality) {
  LengthRatioOptions options;
  options.join_distance = 0.0;
  std::size_t lines = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Points points = Wander(seed);
    for (const LineSegment& segment : DetectByLengthRatio(points, options)) {
      ++lines;
      const std::size_t first = segment.points.front(), last = segment.points.back();
      for (std::size_t j = first + 2; j <= last; ++j) {
        const auto count = static_cast<int>(j - first + 1);
        EXPECT_GT(RatioOf(points, first, j), LengthRatioThreshold(count, options));
      }
      if (last + 1 == points.size()) continue;
      const auto count = static_cast<int>(last + 2 - first);
      EXPECT_LE(RatioOf(points, first, last + 1), LengthRatioThreshold(count, options)) << "could go on";
    }
  }
  EXPECT_GT(lines, 300u);
}

}  // namespace
}  // namespace ariadne::slam
