#include "slam/extract/detect_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "slam/geometry/angles.h"
#include "tests/slam/extract/lines_of_points.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

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
