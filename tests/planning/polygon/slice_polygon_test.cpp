#include "planning/polygon/slice_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "drivers/simulated/box_world_scan.h"
#include "drivers/simulated/random_room.h"
#include "planning/polygon/scan_polygon.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;
constexpr double kPi = std::numbers::pi;

std::vector<LabelledCorner> SeenCorners(const LabelledPolygon& polygon) {
  std::vector<LabelledCorner> seen;
  std::ranges::copy_if(polygon.outer, std::back_inserter(seen), &LabelledCorner::seen);
  return seen;
}

double DistanceFromOrigin(const SliceLine& line) {
  const Vector2d along = line.to_scan - line.from_scan;
  const double share = std::clamp(-line.from_scan.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (line.from_scan + share * along).norm();
}

/// How far a ray from p inside the polygon goes to its first edge; NaN where there is none.
double RangeWithin(const LabelledPolygon& polygon, const Vector2d& p, double bearing) {
  const Vector2d u(std::cos(bearing), std::sin(bearing));
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    const Vector2d a = polygon.outer[i].p_map - p;
    const Vector2d e = polygon.outer[(i + 1) % polygon.outer.size()].p_map - p - a;
    const double across = u.x() * e.y() - u.y() * e.x();
    if (std::abs(across) < 1e-12) continue;
    const double range = (a.x() * e.y() - a.y() * e.x()) / across;
    const double share = (a.x() * u.y() - a.y() * u.x()) / across;
    if (share < 0.0 || share > 1.0 || range < 1e-6) continue;
    nearest = std::isnan(nearest) ? range : std::min(nearest, range);
  }
  return nearest;
}

/// Intersection over union with what the scanner can see at its height, by rays 0.1 degrees apart.
double OverlapWithVisible(const LabelledPolygon& polygon, const drivers::BoxWorld& world,
                          const slam::Pose3& T_map_scan, double heading) {
  double common = 0.0, either = 0.0;
  for (int i = 0; i < 1800; ++i) {
    const double bearing = heading + (i + 0.5 - 900.0) / 1800.0 * kPi;
    const Eigen::Vector3d u(std::cos(bearing), std::sin(bearing), 0.0);
    const double truth = *drivers::CastRay(world, T_map_scan.translation, u);
    const double shown = RangeWithin(polygon, T_map_scan.translation.head<2>(), bearing);
    const double known = std::isnan(shown) ? 0.0 : shown;
    common += std::pow(std::min(truth, known), 2);
    either += std::pow(std::max(truth, known), 2);
  }
  return common / either;
}

double MedianOverlap(double range_sigma, const slam::LineOptions& lines) {
  RandomStream stream = NamedStream(7, "test/slice_polygon/rooms");
  std::vector<double> overlaps;
  for (int view = 0; view < 50; ++view) {
    const drivers::Room room = drivers::DrawRoom(stream);
    const Eigen::Vector3d place = drivers::DrawViewpoint(stream, room);
    const double heading = DrawUniform(stream, -kPi, kPi);
    const slam::Pose3 T_map_laser = slam::ToPose3({heading, Vector2d::Zero()});
    const slam::Pose3 T_map_scan{T_map_laser.rotation, place};
    drivers::BoxScanSettings settings;
    settings.range_sigma = range_sigma;
    settings.slices = 2;
    settings.lowest_pitch = 0.0;
    settings.highest_pitch = 1e-6;
    const slam::Scan scan = drivers::ScanBoxWorld(room.world, T_map_scan, settings, stream);
    ScanPolygonOptions options;
    options.slice.height = place.z();
    options.lines = lines;
    const LabelledPolygon polygon = ScanPolygon({"view", slam::ToPointCloud(scan), T_map_scan}, options);
    RequireSimple(polygon);
    overlaps.push_back(OverlapWithVisible(polygon, room.world, T_map_scan, heading));
  }
  std::ranges::sort(overlaps);
  return overlaps[25];
}

TEST(SlicePolygon, LinesInAnyOrderAndDirectionAreJoinedByBearing) {
  const std::vector<SliceLine> lines{
      {{3.0, 1.0}, {1.0, 3.0}},    // second, runs to the left
      {{-1.0, 3.0}, {-3.0, 1.0}},  // third
      {{3.0, -1.0}, {2.0, -3.0}},  // first, runs to the right
  };
  const slam::Pose2 T_map_scan{0.3, {5.0, -2.0}};
  const std::vector<Vector2d> ends_scan{{2.0, -3.0}, {3.0, -1.0}, {3.0, 1.0},
                                        {1.0, 3.0},  {-1.0, 3.0}, {-3.0, 1.0}};
  const LabelledPolygon paper = SlicePolygon(lines, T_map_scan, {PolygonClosure::kChord});
  ASSERT_EQ(paper.outer.size(), 2 * lines.size());
  for (std::size_t i = 0; i < ends_scan.size(); ++i) {
    EXPECT_LT((paper.outer[i].p_map - T_map_scan * ends_scan[i]).norm(), 1e-9) << i;
    EXPECT_EQ(paper.outer[i].seen, i % 2 == 0) << i;
  }
  const LabelledPolygon through = SlicePolygon(lines, T_map_scan);
  ASSERT_EQ(through.outer.size(), 2 * lines.size() + 1);
  EXPECT_LT((through.outer.back().p_map - T_map_scan.translation).norm(), 1e-12);
}

TEST(SlicePolygon, WhatIsBehindANearerLineIsCut) {
  const std::vector<SliceLine> lines{{{4.0, -2.0}, {4.0, 2.0}}, {{2.0, -0.5}, {2.0, 0.5}}};
  const LabelledPolygon polygon = SlicePolygon(lines, {});
  const std::vector<std::pair<Vector2d, bool>> expected{
      {{4.0, -2.0}, true}, {{4.0, -1.0}, false}, {{2.0, -0.5}, true}, {{2.0, 0.5}, false},
      {{4.0, 1.0}, true},  {{4.0, 2.0}, false},  {{0.0, 0.0}, false}};
  ASSERT_EQ(polygon.outer.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((polygon.outer[i].p_map - expected[i].first).norm(), 1e-9) << i;
    EXPECT_EQ(polygon.outer[i].seen, expected[i].second) << i;
  }
}

TEST(SlicePolygon, OfLinesThatCrossTheNearerHalfOfEachCounts) {
  const std::vector<SliceLine> lines{{{2.0, -1.0}, {4.0, 1.0}}, {{4.0, -1.0}, {2.0, 1.0}}};
  const LabelledPolygon polygon = SlicePolygon(lines, {});
  const std::vector<LabelledCorner> seen = SeenCorners(polygon);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_LT((seen[0].p_map - Vector2d(2.0, -1.0)).norm(), 1e-9);
  EXPECT_LT((seen[1].p_map - Vector2d(3.0, 0.0)).norm(), 1e-9);
  EXPECT_NEAR(SeenLength(polygon), 2.0 * std::sqrt(2.0), 1e-9);
}

TEST(SlicePolygon, ALineBehindTheScannerIsOneEdge) {
  const std::vector<SliceLine> room{{{2.0, -2.0}, {2.0, 2.0}},
                                    {{2.0, 2.0}, {-2.0, 2.0}},
                                    {{-2.0, 2.0}, {-2.0, -2.0}},
                                    {{-2.0, -2.0}, {2.0, -2.0}}};
  const LabelledPolygon polygon = SlicePolygon(room, {});
  EXPECT_EQ(polygon.outer.size(), 4U);
  EXPECT_DOUBLE_EQ(UnseenLength(polygon), 0.0);
  EXPECT_TRUE(Contains(polygon, {0.1, 0.1}));
}

TEST(SlicePolygon, AnyLinesMakeASimpleStarAboutTheScanner) {
  RandomStream stream = NamedStream(1, "test/slice_polygon/any_lines");
  const auto draw = [&] {
    return Vector2d(DrawUniform(stream, -5.0, 5.0), DrawUniform(stream, -5.0, 5.0));
  };
  for (int round = 0; round < 300; ++round) {
    std::vector<SliceLine> lines(static_cast<std::size_t>(DrawUniform(stream, 1.0, 30.0)));
    for (SliceLine& line : lines) {
      const Vector2d from = draw();
      line = {from, from + DrawUniform(stream, 0.0, 0.6) * draw()};
    }
    const slam::Pose2 T_map_scan{DrawUniform(stream, -kPi, kPi), draw()};
    const auto closure = round % 2 == 0 ? PolygonClosure::kChord : PolygonClosure::kThroughScanner;
    const LabelledPolygon polygon = SlicePolygon(lines, T_map_scan, {closure});
    RequireSimple(polygon);
    for (std::size_t i = 0; i < polygon.outer.size();
         ++i) {  // each edge runs from right to left, or along a ray
      const Vector2d a = polygon.outer[i].p_map - T_map_scan.translation;
      const Vector2d b = polygon.outer[(i + 1) % polygon.outer.size()].p_map - T_map_scan.translation;
      EXPECT_GE(a.x() * b.y() - a.y() * b.x(), -1e-6);
    }
    for (int ray = 0; ray < 50; ++ray) {  // the first seen edge of a ray is the nearest line, and no other
      const double bearing = DrawUniform(stream, -kPi, kPi);
      const double heading = T_map_scan.angle + bearing;
      const double shown = RangeWithin(polygon, T_map_scan.translation, heading);
      double nearest = std::numeric_limits<double>::infinity();
      for (const SliceLine& line : lines) {
        if (DistanceFromOrigin(line) < 0.01) continue;
        const LabelledPolygon alone{{{line.from_scan, true}, {line.to_scan, true}}, {}};
        const double range = RangeWithin(alone, Vector2d::Zero(), bearing);
        if (range < nearest) nearest = range;
      }
      if (std::isfinite(nearest)) {
        EXPECT_NEAR(shown, nearest, 1e-3 * nearest);
      }
    }
  }
}

TEST(SlicePolygon, MovesWithTheFrame) {
  const std::vector<SliceLine> lines{{{4.0, -2.0}, {4.0, 2.0}}, {{2.0, -0.5}, {2.0, 0.5}}};
  const slam::Pose2 T_map_scan{2.5, {-40.0, 70.0}};
  const LabelledPolygon here = SlicePolygon(lines, {});
  const LabelledPolygon there = SlicePolygon(lines, T_map_scan);
  ASSERT_EQ(here.outer.size(), there.outer.size());
  for (std::size_t i = 0; i < here.outer.size(); ++i) {
    EXPECT_LT((T_map_scan * here.outer[i].p_map - there.outer[i].p_map).norm(), 1e-12);
    EXPECT_EQ(here.outer[i].seen, there.outer[i].seen);
  }
}

TEST(SlicePolygon, LinesThatShowNothingAreLeftOut) {
  EXPECT_TRUE(SlicePolygon({}, {}).empty());
  const std::vector<SliceLine> useless{{{1.0, 0.0}, {3.0, 0.0}},       // end on
                                       {{-1.0, 0.001}, {1.0, 0.001}},  // through the scanner
                                       {{2.0, 2.0}, {2.0, 2.0}}};      // a point
  EXPECT_TRUE(SlicePolygon(useless, {}).empty());
}

SlicePolygonOptions FreeUpTo(double range, double field_of_view) {
  SlicePolygonOptions options;
  if (field_of_view >= 360.0) options.closure = PolygonClosure::kChord;
  options.free_range = range;
  options.field_of_view = field_of_view;
  return options;
}

TEST(SlicePolygon, WithoutLinesIsWhatIsInRange) {
  const slam::Pose2 T_map_scan{0.7, {3.0, -2.0}};
  for (const double degrees : {90.0, 180.0, 270.0, 360.0}) {
    const LabelledPolygon polygon = SlicePolygon({}, T_map_scan, FreeUpTo(10.0, degrees));
    RequireSimple(polygon);
    EXPECT_EQ(SeenLength(polygon), 0.0);
    const double sector = degrees / 360.0 * kPi * 100.0;
    EXPECT_NEAR(slam::Area(ToPolygon2(polygon)), sector, 2e-3 * sector) << degrees;
    EXPECT_TRUE(Contains(polygon, T_map_scan * Vector2d(9.9, 0.0)));
    EXPECT_EQ(Contains(polygon, T_map_scan * Vector2d(-9.9, 0.1)), degrees > 350.0);
  }
}

TEST(SlicePolygon, IsFreeBesideLinesUpToTheRange) {
  const std::vector<SliceLine> wall{{{4.0, -1.0}, {4.0, 1.0}}};
  for (const double degrees : {180.0, 360.0}) {
    const LabelledPolygon polygon = SlicePolygon(wall, {}, FreeUpTo(10.0, degrees));
    RequireSimple(polygon);
    EXPECT_NEAR(SeenLength(polygon), 2.0, 1e-9);
    EXPECT_FALSE(Contains(polygon, {4.1, 0.0})) << "behind the wall";
    EXPECT_TRUE(Contains(polygon, {9.0, 3.0}) && Contains(polygon, {0.1, -9.8}));
    EXPECT_EQ(Contains(polygon, {-5.0, 0.0}), degrees > 350.0);
  }
  EXPECT_FALSE(Contains(SlicePolygon(wall, {}), {9.0, 3.0})) << "the paper's";
}

TEST(SlicePolygon, LetsNothingThroughACrack) {
  const std::vector<SliceLine> walls{{{4.0, -1.0}, {4.0, 0.0}}, {{4.0, 0.01}, {4.0, 1.0}}};
  EXPECT_FALSE(Contains(SlicePolygon(walls, {}, FreeUpTo(10.0, 180.0)), {6.0, 0.0075})) << "2.5 mrad";
  const std::vector<SliceLine> gap{{{4.0, -1.0}, {4.0, 0.0}}, {{4.0, 0.1}, {4.0, 1.0}}};
  EXPECT_TRUE(Contains(SlicePolygon(gap, {}, FreeUpTo(10.0, 180.0)), {6.0, 0.075})) << "25 mrad";
}

TEST(SlicePolygon, DamagedInputIsAnError) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<SliceLine> lines{{{1.0, 0.0}, {1.0, 1.0}}, {{1.0, nan}, {1.0, 1.0}}};
  EXPECT_THAT(ErrorOf([&] { SlicePolygon(lines, {}); }), testing::HasSubstr("line 1"));
  EXPECT_THAT(ErrorOf([&] { SlicePolygon({}, {nan, {0.0, 0.0}}); }), testing::HasSubstr("pose"));
  slam::PosedCloud cloud{"a", {}, {}};
  EXPECT_TRUE(ScanPolygon(cloud).empty());
  cloud.cloud_laser.positions.emplace_back(0.0, nan, 0.0);
  EXPECT_THAT(ErrorOf([&] { ScanPolygon(cloud); }), testing::HasSubstr("'a'"));
}

TEST(LinesOfScan, PointsThatNoLineExplainsAreCorners) {
  slam::PosedCloud scan{"a", {}, {}};
  for (int i = -10; i <= 10; ++i) scan.cloud_laser.positions.emplace_back(4.0, 0.1 * i, 1.5);
  scan.cloud_laser.positions.emplace_back(3.0, 2.0, 1.5);    // beside the wall
  scan.cloud_laser.positions.emplace_back(3.95, 0.05, 1.5);  // noise of the wall
  ScanPolygonOptions options;
  const auto has_corner = [](const LabelledPolygon& polygon, const Vector2d& p) {
    return std::ranges::any_of(polygon.outer, [&](const auto& c) { return (c.p_map - p).norm() < 2e-3; });
  };
  EXPECT_TRUE(has_corner(ScanPolygon(scan, options), {3.0, 2.0}));
  EXPECT_FALSE(has_corner(ScanPolygon(scan, options), {3.95, 0.05}));
  EXPECT_NEAR(SeenLength(ScanPolygon(scan, options)), 2.0, 0.01);
  options.keep_points = false;
  EXPECT_FALSE(has_corner(ScanPolygon(scan, options), {3.0, 2.0}));
}

// Median over 50 views: what a polygon shows to be free is what the scanner can see.
TEST(ScanPolygon, IsWhatCanBeSeen) { EXPECT_GE(MedianOverlap(0.0, LinesForPolygons()), 0.99); }

TEST(ScanPolygon, IsWhatCanBeSeenAlsoWithTheScannersNoise) {
  EXPECT_GE(MedianOverlap(0.005, LinesForPolygons()), 0.97);
  EXPECT_GE(MedianOverlap(0.005, {}), 0.97);
  EXPECT_GE(MedianOverlap(0.0, {}), 0.97);
}

}  // namespace
}  // namespace ariadne::planning
