#include "slam/extract/detect_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "slam/base/random.h"
#include "slam/extract/hough_accumulator.h"
#include "slam/geometry/angles.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Indices = std::vector<std::size_t>;

/// Appends points from one place towards another, every `spacing` [m], both ends included.
void AppendLine(Points& points, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                double spacing = 0.05) {
  const auto steps = static_cast<int>(std::round((to - from).norm() / spacing));
  for (int i = 0; i <= steps; ++i) points.emplace_back(from + (to - from) * i / steps);
}

LineOptions OptionsOf(LineMethod method, PointOrder order = PointOrder::kOrdered) {
  LineOptions options;
  options.method = method;
  options.hough.order = order;
  return options;
}

std::vector<LineSegment> FromRightToLeft(std::vector<LineSegment> segments) {
  std::ranges::sort(segments, {}, [](const LineSegment& s) { return s.points.front(); });
  return segments;
}

struct Case {
  std::string name;
  LineOptions options;
};

class DetectLinesTest : public testing::TestWithParam<Case> {
 protected:
  static std::vector<LineSegment> Detect(const Points& points) {
    return FromRightToLeft(DetectLines(points, GetParam().options));
  }
};

TEST_P(DetectLinesTest, FindsAWall) {
  Points points;
  AppendLine(points, {2.0, -1.5}, {2.0, 1.0});
  const std::vector<LineSegment> segments = Detect(points);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_NEAR(segments[0].angle, 0.0, 1e-9);
  EXPECT_NEAR(segments[0].offset, 2.0, 1e-9);
  EXPECT_LT((segments[0].from - points.front()).norm(), 1e-9);
  EXPECT_LT((segments[0].to - points.back()).norm(), 1e-9);
  EXPECT_EQ(segments[0].points.size(), points.size());
}

TEST_P(DetectLinesTest, EndsLinesAtTheCorner) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 2.0});
  points.pop_back();
  AppendLine(points, {2.0, 2.0}, {-1.0, 2.0});
  const std::vector<LineSegment> segments = Detect(points);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_NEAR(segments[0].angle, 0.0, RadFromDeg(0.6));
  EXPECT_NEAR(segments[1].angle, RadFromDeg(90.0), RadFromDeg(0.6));
  EXPECT_LT((segments[0].to - Eigen::Vector2d(2.0, 2.0)).norm(), 0.051);
  EXPECT_LT((segments[1].from - Eigen::Vector2d(2.0, 2.0)).norm(), 0.16);
}

TEST_P(DetectLinesTest, EndsALineAtADoor) {
  Points points;
  AppendLine(points, {2.0, -2.0}, {2.0, -0.5});
  AppendLine(points, {2.0, 0.5}, {2.0, 2.0});
  const std::vector<LineSegment> segments = Detect(points);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_NEAR(segments[0].to.y(), -0.5, 1e-9);
  EXPECT_NEAR(segments[1].from.y(), 0.5, 1e-9);
}

TEST_P(DetectLinesTest, EndsALineAtAJumpEdge) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 0.0});
  AppendLine(points, {3.0, 0.05}, {3.0, 1.0});
  const std::vector<LineSegment> segments = Detect(points);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_NEAR(segments[0].offset, 2.0, 1e-9);
  EXPECT_NEAR(segments[1].offset, 3.0, 1e-9);
}

TEST_P(DetectLinesTest, FindsNoLineWhereThereIsNone) {
  EXPECT_TRUE(Detect({}).empty());
  EXPECT_TRUE(Detect({{1.0, 2.0}}).empty());
  EXPECT_TRUE(Detect(Points(50, {1.0, 2.0})).empty()) << "one place is no line";
  EXPECT_TRUE(Detect(Points(50, {0.0, 0.0})).empty());
  EXPECT_TRUE(Detect({{1.0, 0.0}, {0.0, 9.0}, {-5.0, 0.0}, {0.0, -3.0}}).empty()) << "far apart";
}

TEST_P(DetectLinesTest, RefusesPointsThatAreNoPlaces) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Points points{{1.0, 2.0}, {1.0, bad}};
    EXPECT_NE(ErrorOf([&] { Detect(points); }).find("point 1 of the slice is (1, "), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(, DetectLinesTest,
                         testing::Values(Case{"LengthRatio", OptionsOf(LineMethod::kLengthRatio)},
                                         Case{"Hough", OptionsOf(LineMethod::kHough)},
                                         Case{"HoughUnordered",
                                              OptionsOf(LineMethod::kHough, PointOrder::kUnordered)},
                                         Case{"SplitAndMerge", OptionsOf(LineMethod::kSplitAndMerge)}),
                         [](const auto& c) { return c.param.name; });

TEST(DetectLinesOptions, AreCheckedByName) {
  LengthRatioOptions ratio;
  ratio.epsilon_many = 1.5;
  EXPECT_EQ(ErrorOf([&] { DetectByLengthRatio({}, ratio); }),
            "length_ratio.epsilon_many is 1.5 , but must be in 0 to 1");
  HoughOptions hough;
  hough.noise.range_sigma = -1.0;
  EXPECT_NE(ErrorOf([&] { DetectByHough({}, hough); }).find("hough.noise.range_sigma is -1 m"),
            std::string::npos);
}

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

TEST(Hough, LetsAnEndServeASecondLineWhereOrderIsKnown) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 2.0});
  const std::size_t corner = points.size() - 1;
  points.pop_back();
  AppendLine(points, {2.0, 2.0}, {-0.5, 2.0});
  HoughOptions options;
  const std::vector<LineSegment> ordered = DetectByHough(points, options);
  ASSERT_EQ(ordered.size(), 2u);
  EXPECT_EQ(ordered[0].points.back(), corner);
  EXPECT_EQ(ordered[1].points.front(), corner);
  options.order = PointOrder::kUnordered;
  const std::vector<LineSegment> unordered = DetectByHough(points, options);
  ASSERT_EQ(unordered.size(), 2u);
  EXPECT_EQ(unordered[0].points.size() + unordered[1].points.size(), points.size());
}

TEST(Hough, NeedsNoOrder) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 2.0});
  AppendLine(points, {1.5, 2.0}, {-1.0, 2.0});
  AppendLine(points, {-1.5, 0.5}, {-2.0, -2.0});
  HoughOptions options;
  options.order = PointOrder::kUnordered;
  const std::vector<LineSegment> segments = DetectByHough(points, options);
  ASSERT_EQ(segments.size(), 3u);
  RandomStream stream = NamedStream(5, "detect_lines/shuffle");
  for (int trial = 0; trial < 10; ++trial) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[stream() % i]);
    const std::vector<LineSegment> shuffled = DetectByHough(points, options);
    ASSERT_EQ(shuffled.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((shuffled[i].from - segments[i].from).norm(), 1e-9);
      EXPECT_LT((shuffled[i].to - segments[i].to).norm(), 1e-9);
      EXPECT_EQ(shuffled[i].points.size(), segments[i].points.size());
    }
  }
}

TEST(Hough, CountsEmptyBins) {
  Points points;
  AppendLine(points, {2.0, -1.0}, {2.0, 0.0}, 0.01);
  AppendLine(points, {2.0, 0.1}, {2.0, 1.0}, 0.01);
  HoughOptions options;
  options.order = PointOrder::kUnordered;
  EXPECT_EQ(DetectByHough(points, options).size(), 1u);
  options.max_empty_bins = 3;  // the group's
  EXPECT_EQ(DetectByHough(points, options).size(), 2u);
}

TEST(Hough, LooksAtSoManyLinesAndSoFar) {
  Points points;
  AppendLine(points, {2.0, -2.0}, {2.0, 2.0});
  AppendLine(points, {1.0, 20.0}, {-1.0, 20.0});
  HoughOptions options;
  std::vector<LineSegment> segments = DetectByHough(points, options);
  ASSERT_EQ(segments.size(), 1u) << "the other is beyond max_distance";
  EXPECT_EQ(segments[0].points.size(), 81u);
  options.max_distance = 30.0;
  EXPECT_EQ(DetectByHough(points, options).size(), 2u);
  options.max_passes = 1;
  EXPECT_EQ(DetectByHough(points, options).size(), 1u);
}

TEST(Hough, RefusesWhatNeedsTooMuchMemory) {
  HoughOptions options;
  options.max_distance = 1000.0;
  EXPECT_NE(ErrorOf([&] {
              DetectByHough(Points{{-900.0, 0.0}, {900.0, 1.0}}, options);
            }).find("lower hough.max_distance"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              DetectByHough(Points(HoughAccumulator::kMaxPoints + 1, {1.0, 1.0}), {});
            }).find("reduce them"),
            std::string::npos);
}

TEST(HoughAccumulator, FindsTheLineWithMostVotes) {
  RandomStream stream = NamedStream(6, "detect_lines/accumulator");
  for (int trial = 0; trial < 20; ++trial) {
    const double angle = DrawUniform(stream, -1.5, 1.5), offset = DrawUniform(stream, 1.0, 3.0);
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle)), along(-normal.y(), normal.x());
    Points points;
    for (int i = 0; i < 60; ++i) points.emplace_back(offset * normal + 0.03 * i * along);
    for (int i = 0; i < 40; ++i)
      points.emplace_back(DrawUniform(stream, -3, 3), DrawUniform(stream, -3, 3));
    HoughAccumulator accumulator(points, 75.0);
    const HoughAccumulator::Peak peak = accumulator.Highest();
    EXPECT_GE(peak.votes, 45) << "of 60; the border of two cells may run along the line";
    const Eigen::Vector2d found(std::cos(peak.theta), std::sin(peak.theta));
    for (int i = 0; i < 60; i += 59)
      EXPECT_NEAR(found.dot(points[i]), peak.offset, 0.045) << "a cell or two";
    accumulator.Withdraw(std::span(points).first(60));
    EXPECT_LE(accumulator.Highest().votes, 12);
    accumulator.Withdraw(std::span(points).subspan(60));
    EXPECT_EQ(accumulator.Highest().votes, 0);
  }
}

TEST(HoughAccumulator, KeepsACellClosedWhateverIsTakenBack) {
  Points points;
  for (std::size_t i = 0; i < HoughAccumulator::kMaxPoints; ++i) {
    points.emplace_back(1.0,
                        2.0 * static_cast<double>(i) / static_cast<double>(HoughAccumulator::kMaxPoints));
  }
  HoughAccumulator accumulator(points, 75.0);
  const HoughAccumulator::Peak peak = accumulator.Highest();
  EXPECT_GT(peak.votes, 12000);
  accumulator.Close(peak);
  const HoughAccumulator::Peak next = accumulator.Highest();
  EXPECT_FALSE(next.theta_cell == peak.theta_cell && next.rho_cell == peak.rho_cell);
  accumulator.Withdraw(points);
  EXPECT_EQ(accumulator.Highest().votes, 0);
}

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

TEST(EdgePoints, AreTheEndsOfTheLines) {
  Points points;
  AppendLine(points, {2.0, -2.0}, {2.0, -0.5});
  AppendLine(points, {3.0, 0.5}, {3.0, 2.0});
  const std::vector<LineSegment> segments = DetectLines(points, {});
  ASSERT_EQ(segments.size(), 2u);
  const Points ends = EdgePoints(segments);
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_LT((ends[0] - Eigen::Vector2d(2.0, -2.0)).norm(), 1e-9);
  EXPECT_LT((ends[1] - Eigen::Vector2d(2.0, -0.5)).norm(), 1e-9);
  EXPECT_LT((ends[2] - Eigen::Vector2d(3.0, 0.5)).norm(), 1e-9);
  EXPECT_LT((ends[3] - Eigen::Vector2d(3.0, 2.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace ariadne::slam
