#include "slam/extract/fit_segment.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <numeric>

#include "slam/base/random.h"
#include "slam/extract/slice_points.h"
#include "slam/geometry/angles.h"
#include "slam/reduce/reduce.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(FitSegment, IsExactOnALine) {
  const Points points{{2.0, -1.0}, {2.0, 0.5}, {2.0, 3.0}};
  const std::optional<LineSegment> segment = FitSegment(points, 0, 2, {});
  ASSERT_TRUE(segment);
  EXPECT_NEAR(segment->angle, 0.0, 1e-12);
  EXPECT_NEAR(segment->offset, 2.0, 1e-12);
  EXPECT_NEAR(segment->rms, 0.0, 1e-12);
  EXPECT_LT((segment->from - points[0]).norm(), 1e-12) << "right";
  EXPECT_LT((segment->to - points[2]).norm(), 1e-12) << "left";
  EXPECT_EQ(segment->points, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_GT(segment->Distance({3.0, 0.0}), 0.0) << "the normal points away from the scanner";
}

TEST(FitSegment, RunsFromRightToLeftOnAllSides) {
  const Points square{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (std::size_t side = 0; side < 4; ++side) {
    const std::optional<LineSegment> segment = FitSegment(square, side, side + 1, {});
    ASSERT_TRUE(segment);
    EXPECT_NEAR(segment->offset, 1.0, 1e-12);
    EXPECT_NEAR(WrapAngle(segment->angle - static_cast<double>(side) * std::numbers::pi / 2.0), 0.0, 1e-12);
    EXPECT_LT((segment->from - square[side]).norm(), 1e-12);
  }
}

TEST(FitSegment, UsesTheChosenPointsAlone) {
  const Points points{{2.0, 0.0}, {9.0, 9.0}, {2.0, 1.0}, {2.0, 2.0}};
  const std::vector<std::size_t> chosen{0, 2, 3};
  const std::optional<LineSegment> segment = FitSegment(points, chosen, {});
  ASSERT_TRUE(segment);
  EXPECT_NEAR(segment->offset, 2.0, 1e-12);
  EXPECT_EQ(segment->points, chosen);
}

TEST(FitSegment, IsNothingWithoutTwoPlaces) {
  EXPECT_FALSE(FitSegment(Points{}, std::vector<std::size_t>{}, {}));
  EXPECT_FALSE(FitSegment(Points{{1.0, 2.0}}, 0, 0, {}));
  EXPECT_FALSE(FitSegment(Points(5, {1.0, 2.0}), 0, 4, {}));
  EXPECT_FALSE(FitSegment(Points{{1.0, 2.0}, {1.0, 2.0 + 1e-15}}, 0, 1, {})) << "but for rounding";
}

TEST(FitSegment, IsFiniteThroughTheScanner) {
  const Points points{{-1.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}};
  const std::optional<LineSegment> segment = FitSegment(points, 0, 2, {});
  ASSERT_TRUE(segment);
  EXPECT_NEAR(segment->offset, 0.0, 1e-12);
  EXPECT_TRUE(segment->covariance.allFinite());
}

TEST(SigmaAcross, IsOfTheRangeAheadAndOfTheBearingAside) {
  SliceNoise noise;
  noise.range_sigma = 0.01;
  noise.bearing_sigma = 0.001;
  EXPECT_NEAR(SigmaAcross(Eigen::Vector2d::UnitX(), {5.0, 0.0}, noise), 0.01, 2e-5);
  EXPECT_NEAR(SigmaAcross(Eigen::Vector2d::UnitX(), {0.0, 5.0}, noise), 0.005, 2e-5);
}

/// Without what neighbours share, so that a draw per point is all of it.
SliceNoise Independent(double factor = 1.0) {
  SliceNoise noise;
  noise.range_sigma *= factor;
  noise.bearing_sigma *= factor;
  noise.systematic_sigma = 0.0;
  return noise;
}

/// A wall of `count` points, seen by a scanner with these sigmas; and its true line.
struct NoisyWall {
  Points points;
  double angle, offset;
};

NoisyWall DrawWall(RandomStream& stream, int count, const SliceNoise& noise) {
  NoisyWall wall{{}, DrawUniform(stream, -3.0, 3.0), DrawUniform(stream, 0.5, 4.0)};
  const double first = DrawUniform(stream, -1.1, 0.3);  // bearing from the normal
  const double step = DrawUniform(stream, 0.3, 0.9) / count;
  for (int i = 0; i < count; ++i) {
    const double bearing = first + i * step;
    const double range = wall.offset / std::cos(bearing) + DrawNormal(stream, 0.0, noise.range_sigma);
    const double seen = wall.angle + bearing + DrawNormal(stream, 0.0, noise.bearing_sigma);
    wall.points.emplace_back(range * std::cos(seen), range * std::sin(seen));
  }
  return wall;
}

struct Nees {
  double mean = 0.0;
  double share_within_95 = 0.0;
};

Nees NeesOfFits(int count, const SliceNoise& truth, const SliceNoise& assumed) {
  constexpr int kDraws = 4000;
  constexpr double kQuantile = 5.991;  // chi-square, 2 degrees of freedom
  RandomStream stream = NamedStream(static_cast<std::uint64_t>(count), "fit_segment/nees");
  Nees nees;
  for (int i = 0; i < kDraws; ++i) {
    const NoisyWall wall = DrawWall(stream, count, truth);
    const std::optional<LineSegment> fit = FitSegment(wall.points, 0, wall.points.size() - 1, assumed);
    const Eigen::Vector2d error(WrapAngle(fit->angle - wall.angle), fit->offset - wall.offset);
    const double value = error.dot(fit->covariance.inverse() * error);
    nees.mean += value / kDraws;
    nees.share_within_95 += (value < kQuantile ? 1.0 : 0.0) / kDraws;
  }
  return nees;
}

// The mean of a chi-square of 2 is 2, and 95 % lie below its quantile. As the scatter of few points scales
// the covariance, the errors follow a distribution with longer tails: by theory the shares are 92.6 % (of
// 8 points) to 94.4 % (of 60). 4000 draws tell them to 0.4 % (one sigma), and the mean to 0.03.
TEST(FitSegment, HasAnHonestCovariance) {
  for (const int count : {4, 8, 20, 60}) {
    const Nees nees = NeesOfFits(count, Independent(), Independent());
    EXPECT_GT(nees.mean, 1.85) << count;
    EXPECT_LT(nees.mean, 2.35) << count;
    EXPECT_GT(nees.share_within_95, 0.91) << count;
    EXPECT_LT(nees.share_within_95, 0.965) << count;
  }
}

TEST(FitSegment, LearnsTheNoiseFromTheScatter) {
  const Nees nees = NeesOfFits(60, Independent(3.0), Independent());
  EXPECT_GT(nees.mean, 1.85);
  EXPECT_LT(nees.mean, 2.45);
  SliceNoise stubborn = Independent();
  stubborn.prior_points = 1e6;
  EXPECT_GT(NeesOfFits(60, Independent(3.0), stubborn).mean, 10.0) << "nine times as large";
}

TEST(FitSegment, CountsWhatRangesHaveInCommon) {
  constexpr double kLonger = 1e-4;
  RandomStream stream = NamedStream(1, "fit_segment/systematic");
  for (int trial = 0; trial < 20; ++trial) {
    const NoisyWall wall = DrawWall(stream, 30, Independent());
    Points moved;
    for (const Eigen::Vector2d& p : wall.points) moved.emplace_back(p + kLonger * p.normalized());
    SliceNoise alike = Independent();
    alike.systematic_sigma = 0.01;
    alike.systematic_length = 1000.0;  // the same at all ranges
    const std::optional<LineSegment> alone = FitSegment(wall.points, 0, 29, Independent());
    const std::optional<LineSegment> longer = FitSegment(moved, 0, 29, Independent());
    const std::optional<LineSegment> honest = FitSegment(wall.points, 0, 29, alike);
    const Eigen::Vector2d change(longer->angle - alone->angle, longer->offset - alone->offset);
    const Eigen::Matrix2d expected = std::pow(0.01 / kLonger, 2) * change * change.transpose();
    EXPECT_LT((honest->covariance - alone->covariance - expected).norm(), 0.05 * expected.norm());
  }
}

TEST(SlicePoints, AreWhereTheCloudHasThem) {
  ScannerModel scanner;
  scanner.angle_step = RadFromDeg(45.0);
  LaserSweep sweep;
  sweep.pitch = RadFromDeg(30.0);
  sweep.ranges = {1.0F, 2.0F, LaserSweep::kNoReturn, 4.0F, 5.0F};
  const Points points = SlicePoints(scanner, sweep);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_LT((points[0] - Eigen::Vector2d(0.0, -1.0)).norm(), 1e-12) << "to the right";
  EXPECT_LT((points[1] - Eigen::Vector2d(2.0, -2.0) / std::sqrt(2.0)).norm(), 1e-12);
  EXPECT_LT((points[3] - Eigen::Vector2d(0.0, 5.0)).norm(), 1e-12) << "to the left";
  const PointCloud cloud_laser = ToPointCloud({scanner, {}, {sweep, sweep}});
  const Points from_cloud = SlicePoints(cloud_laser, 1);
  ASSERT_EQ(from_cloud.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((points[i] - from_cloud[i]).norm(), 1e-6) << i;
  EXPECT_EQ(ErrorOf([&] { SlicePoints(cloud_laser, 2); }), "there is no slice 2 in a cloud of 2 slices");
}

TEST(JoinNeighbors, MakesTheReducedPointsOfThePaper) {
  RandomStream stream = NamedStream(3, "slice_points/join");
  PointCloud cloud_laser;
  cloud_laser.slice_begin = {0};
  Points points;
  for (int i = 0; i < 181; ++i) {
    const double bearing = RadFromDeg(i), range = 3.0 + DrawNormal(stream, 0.0, 0.1);
    points.emplace_back(range * std::sin(bearing), -range * std::cos(bearing));
    cloud_laser.positions.emplace_back(points.back().x(), points.back().y(), 0.0);
  }
  for (const double join_distance : {0.0, 0.1, 0.3}) {
    const std::vector<JoinedPoint> joined = JoinNeighbors(points, join_distance);
    const PointCloud reduced = ReduceSlices(cloud_laser, join_distance, 1);
    ASSERT_EQ(joined.size(), reduced.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      EXPECT_LT((joined[i].mean - reduced.positions[i].head<2>()).norm(), 1e-12);
      EXPECT_EQ(joined[i].first, next);
      next = joined[i].last + 1;
    }
    EXPECT_EQ(next, points.size());
  }
}

}  // namespace
}  // namespace ariadne::slam
