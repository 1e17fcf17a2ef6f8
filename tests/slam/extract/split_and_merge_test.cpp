#include "slam/extract/split_and_merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam/base/random.h"
#include "slam/geometry/angles.h"
#include "tests/slam/extract/lines_of_points.h"

namespace ariadne::slam {
namespace {

TEST(SplitAndMerge, PassesOverAStray) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 1.0});
  points[20].x() = 1.8;
  const std::vector<LineSegment> segments = DetectBySplitAndMerge(points, {});
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].points.size(), points.size() - 1);
  EXPECT_FALSE(std::ranges::binary_search(segments[0].points, 20u));
  SplitAndMergeOptions strict;
  strict.max_strays = 0;
  EXPECT_EQ(DetectBySplitAndMerge(points, strict).size(), 2u);
}

TEST(SplitAndMerge, GivesPointsAtACornerToTheirWall) {
  Points exact;
  AppendLine(exact, {2.0, -1.0}, {2.0, 1.97});
  const std::size_t first_of_second = exact.size();
  AppendLine(exact, {1.97, 2.0}, {-1.0, 2.0});
  RandomStream stream = NamedStream(7, "detect_lines/corner");
  std::size_t astray = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Points points = exact;
    for (Eigen::Vector2d& p : points) p += DrawNormal(stream, 0.0, 0.006) * p.normalized();
    const std::vector<LineSegment> segments = DetectBySplitAndMerge(points, {});
    ASSERT_EQ(segments.size(), 2u);
    astray += std::max(segments[0].points.back() + 1, first_of_second) -
              std::min(segments[0].points.back() + 1, first_of_second);
  }
  EXPECT_LE(astray, 20u) << "of 200 corners";
}

TEST(SplitAndMerge, TellsTwoPlacesOfAWallFromABend) {
  for (const double bend_deg : {0.0, 10.0}) {
    const double bend = RadFromDeg(bend_deg);
    Points points;
    AppendLine(points, {2.0, -1.5}, {2.0, 0.0});
    points.pop_back();
    AppendLine(points, {2.0, 0.0}, {2.0 - 1.5 * std::sin(bend), 1.5 * std::cos(bend)});
    EXPECT_EQ(DetectBySplitAndMerge(points, {}).size(), bend_deg == 0.0 ? 1u : 2u);
  }
}

TEST(SplitAndMerge, FindsTheSidesOfASliceThatComesBackToItsBeginning) {
  const Points corners{{2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}, {-2.0, -2.0}};
  Points points;
  for (std::size_t side = 0; side < 4; ++side) {
    AppendLine(points, corners[side], corners[(side + 1) % 4]);
    if (side < 3) points.pop_back();
  }
  ASSERT_EQ(points.front(), points.back());
  const std::vector<LineSegment> segments = DetectBySplitAndMerge(points, {});
  ASSERT_EQ(segments.size(), 4u);
  for (const LineSegment& segment : segments) {
    EXPECT_NEAR(segment.offset, 2.0, 1e-9);
    EXPECT_GT(segment.Length(), 3.9);
  }
}

}  // namespace
}  // namespace ariadne::slam
