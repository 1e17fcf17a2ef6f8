#include "slam/extract/hough_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "slam/base/random.h"
#include "slam/extract/hough_accumulator.h"
#include "tests/slam/extract/lines_of_points.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

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

}  // namespace
}  // namespace ariadne::slam
