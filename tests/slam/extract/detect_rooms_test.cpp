#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "experiments/metrics/statistics.h"
#include "slam/extract/detect_lines.h"
#include "slam/geometry/angles.h"
#include "tests/slam/extract/simulated_slice.h"

/// Every detector with its defaults, in rooms that it was not tuned on.
namespace ariadne::slam {
namespace {

using experiments::Median;

constexpr std::uint64_t kFirstSeed = 1001;
constexpr std::size_t kRooms = 60;

struct Detector {
  std::string name;
  LineMethod method;
  PointOrder order = PointOrder::kOrdered;
  double least_within_ellipse = 0.88;  // some take points from beyond a corner

  LineOptions Options() const {
    LineOptions options;
    options.method = method;
    options.hough.order = order;
    return options;
  }
  bool needs_order() const { return method != LineMethod::kHough || order == PointOrder::kOrdered; }
};

const std::vector<SimulatedSlice>& Slices() {
  static const std::vector<SimulatedSlice> slices = [] {
    std::vector<SimulatedSlice> made;
    for (std::uint64_t seed = kFirstSeed; made.size() < kRooms; ++seed) made.push_back(SimulateSlice(seed));
    return made;
  }();
  return slices;
}

std::vector<Eigen::Vector2d> Shuffled(std::vector<Eigen::Vector2d> points) {
  RandomStream stream = NamedStream(1, "detect_rooms/shuffle");
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[stream() % i]);
  return points;
}

class DetectRooms : public testing::TestWithParam<Detector> {
 protected:
  static std::vector<LineSegment> Detect(const std::vector<Eigen::Vector2d>& points) {
    return DetectLines(points, GetParam().Options());
  }
};

TEST_P(DetectRooms, FindsTheWallsAndLittleElse) {
  experiments::LineScore score;
  for (const SimulatedSlice& slice : Slices()) {
    const auto segments = Detect(GetParam().needs_order() ? slice.points : Shuffled(slice.points));
    score += experiments::ScoreLines(segments, slice.surfaces);
  }
  ASSERT_GT(score.walls, 200u);
  EXPECT_GE(score.Recall(), 0.95);
  EXPECT_GE(score.Precision(), 0.9);
  EXPECT_LE(Median(score.angles), RadFromDeg(0.5));
  EXPECT_LE(Median(score.offsets), 0.01);
  EXPECT_LE(Median(score.ends), 0.05);
  EXPECT_GE(score.ShareOfEndsWithin(0.05), 0.7);
  RecordProperty("walls", std::to_string(score.walls));
  RecordProperty("recall", std::to_string(score.Recall()));
  RecordProperty("precision", std::to_string(score.Precision()));
  RecordProperty("median_angle_deg", std::to_string(DegFromRad(Median(score.angles))));
  RecordProperty("median_offset", std::to_string(Median(score.offsets)));
  RecordProperty("median_end", std::to_string(Median(score.ends)));
  RecordProperty("share_of_ends_within_5cm", std::to_string(score.ShareOfEndsWithin(0.05)));
}

TEST_P(DetectRooms, ExplainsPointsByTheLinesNearThem) {
  for (const SimulatedSlice& slice : Slices()) {
    for (const LineSegment& segment : Detect(slice.points)) {
      ASSERT_GE(segment.points.size(), 4u);
      EXPECT_TRUE(std::ranges::adjacent_find(segment.points, std::greater_equal<>()) ==
                  segment.points.end());
      const Eigen::Vector2d along = (segment.to - segment.from).normalized();
      double squares = 0.0;
      for (const std::size_t i : segment.points) {
        const double place = along.dot(slice.points.at(i) - segment.from);
        EXPECT_TRUE(place > -1e-9 && place < segment.Length() + 1e-9) << "outside of the end points";
        squares += std::pow(segment.Distance(slice.points[i]), 2);
      }
      EXPECT_NEAR(segment.rms, std::sqrt(squares / static_cast<double>(segment.points.size())), 1e-9);
      EXPECT_NEAR(segment.Distance(segment.from), 0.0, 1e-9);
      EXPECT_NEAR(segment.Distance(segment.to), 0.0, 1e-9);
      EXPECT_GT(segment.covariance.determinant(), 0.0);
    }
  }
}

TEST_P(DetectRooms, DoesNotDependOnTheHeadingOfTheScanner) {
  RandomStream stream = NamedStream(2, "detect_rooms/heading");
  std::size_t walls = 0, lost = 0;
  for (const SimulatedSlice& slice : Slices()) {
    const Pose2 T_b_a{DrawUniform(stream, -3.0, 3.0), Eigen::Vector2d::Zero()};
    std::vector<Eigen::Vector2d> points_b;
    for (const Eigen::Vector2d& p_a : slice.points) points_b.push_back(T_b_a * p_a);
    const std::vector<LineSegment> segments_a = Detect(slice.points), segments_b = Detect(points_b);
    for (TrueWall wall : slice.Walls()) {
      if (SegmentOf(segments_a, wall) == nullptr) continue;
      ++walls;
      wall.from = T_b_a * wall.from;
      wall.to = T_b_a * wall.to;
      wall.angle += T_b_a.angle;
      if (SegmentOf(segments_b, wall) == nullptr) ++lost;
    }
    if (GetParam().method == LineMethod::kHough) continue;  // its cells do not turn with the points
    ASSERT_EQ(segments_a.size(), segments_b.size());
    for (std::size_t i = 0; i < segments_a.size(); ++i) {
      const LineSegment &a = segments_a[i], &b = segments_b[i];
      EXPECT_EQ(a.points, b.points);
      EXPECT_LT((T_b_a * a.from - b.from).norm(), 1e-9);
      EXPECT_LT((T_b_a * a.to - b.to).norm(), 1e-9);
      EXPECT_LT((a.covariance - b.covariance).norm(), 1e-6 * a.covariance.norm());
    }
  }
  EXPECT_LE(lost, walls / 50);
}

/// Share of the walls that are found within the 95 % ellipse of their segment's covariance.
double ShareWithinEllipse(const LineOptions& options) {
  constexpr double kQuantile = 5.991;  // chi-square, 2 degrees of freedom
  double found = 0.0, within = 0.0;
  for (const SimulatedSlice& slice : Slices()) {
    const std::vector<LineSegment> segments = DetectLines(slice.points, options);
    for (const TrueWall& wall : slice.Walls()) {
      const LineSegment* const segment = SegmentOf(segments, wall);
      if (segment == nullptr) continue;
      const Eigen::Vector2d error(WrapAngle(segment->angle - wall.angle), segment->offset - wall.offset);
      found += 1.0;
      within += error.dot(segment->covariance.inverse() * error) < kQuantile ? 1.0 : 0.0;
    }
  }
  return within / found;
}

TEST_P(DetectRooms, KnowsHowWrongItsLinesAre) {
  LineOptions options = GetParam().Options();
  EXPECT_GE(ShareWithinEllipse(options), GetParam().least_within_ellipse);
  for (SliceNoise* noise :
       {&options.length_ratio.noise, &options.hough.noise, &options.split_and_merge.noise}) {
    noise->systematic_sigma = 0.0;
  }
  EXPECT_LE(ShareWithinEllipse(options), 0.4) << "the scatter does not show the systematic error";
}

TEST_P(DetectRooms, GivesTheSameBytesAgain) {
  for (const SimulatedSlice& slice : Slices()) {
    const std::vector<LineSegment> once = Detect(slice.points), again = Detect(slice.points);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      const auto all = [](const LineSegment& s) {
        return std::tie(s.from, s.to, s.angle, s.offset, s.covariance, s.rms, s.points);
      };
      EXPECT_EQ(all(once[i]), all(again[i]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , DetectRooms,
    testing::Values(Detector{"LengthRatio", LineMethod::kLengthRatio},
                    Detector{"Hough", LineMethod::kHough},
                    Detector{"HoughUnordered", LineMethod::kHough, PointOrder::kUnordered},
                    Detector{"SplitAndMerge", LineMethod::kSplitAndMerge, PointOrder::kOrdered, 0.93}),
    [](const auto& detector) { return detector.param.name; });

}  // namespace
}  // namespace ariadne::slam
