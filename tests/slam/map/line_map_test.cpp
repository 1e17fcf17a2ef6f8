#include "slam/map/line_map.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "drivers/simulated/box_world_scan.h"
#include "slam/geometry/angles.h"
#include "slam/map/layer_names.h"
#include "slam/map/scan_layers.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PosedCloud ScanOffice(const Pose2& stop, std::uint64_t seed) {
  static const drivers::BoxWorld office = drivers::MakeOffice();
  Pose3 T_map_laser = ToPose3(stop);
  T_map_laser.translation.z() = 1.0;
  RandomStream noise = NamedStream(seed, "line_map/range");
  drivers::BoxScanSettings settings;
  settings.slices = 128;
  return {"scan", ToPointCloud(ScanBoxWorld(office, T_map_laser, settings, noise)), T_map_laser};
}

const std::vector<PosedCloud>& Scans() {
  static const std::vector<PosedCloud> scans = [] {
    std::vector<PosedCloud> taken;
    for (const Pose2& stop : drivers::OfficeTour()) taken.push_back(ScanOffice(stop, taken.size()));
    return taken;
  }();
  return scans;
}

/// How far a place is from the nearest surface of the office, at the height of the slice [m].
double DistanceFromSurface(const Eigen::Vector2d& p) {
  double least = std::numeric_limits<double>::max();
  for (const Box3& solid : drivers::MakeOffice().solids) {
    if (solid.min().z() > 1.5 || solid.max().z() < 1.5) continue;
    const Eigen::AlignedBox2d box(solid.min().head<2>(), solid.max().head<2>());
    const double inside = std::min((p - box.min()).minCoeff(), (box.max() - p).minCoeff());
    least = std::min(least, inside > 0.0 ? inside : box.exteriorDistance(p));
  }
  return least;
}

class LineMapOfOffice : public testing::TestWithParam<LineMethod> {};

TEST_P(LineMapOfOffice, HasLinesOnTheWalls) {
  LineMapOptions options;
  options.lines.method = GetParam();
  const LineMap map = MakeLineMap(Scans(), options);
  ASSERT_EQ(map.slices.size(), Scans().size());
  double on_wall = 0.0, length = 0.0;
  for (const MapLine& line : map.lines) {
    EXPECT_GE(line.Length(), options.min_length);
    EXPECT_LT(line.Rms(), 0.015);
    for (double share = 0.05; share < 1.0; share += 0.1) {
      const Eigen::Vector2d p = line.from_map + share * (line.to_map - line.from_map);
      length += 0.1 * line.Length();
      if (DistanceFromSurface(p) < 0.015) on_wall += 0.1 * line.Length();
    }
  }
  RecordProperty("length", std::to_string(length));
  EXPECT_GT(length, 40.0);
  EXPECT_GT(on_wall, 0.97 * length);  // a line goes on across a door post's corner, as far as points do
  // The walls of the corridor (14 m each, a door in either) are seen by all scans, and are one line a
  // piece.
  EXPECT_LT(map.lines.size(), 30U);
  EXPECT_GT(map.lines.front().Length(), 7.0);
  EXPECT_GE(map.lines.front().scans.size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Methods, LineMapOfOffice,
                         testing::Values(LineMethod::kLengthRatio, LineMethod::kHough,
                                         LineMethod::kSplitAndMerge),
                         [](const auto& method) { return std::string(NameOf(method.param)); });

TEST(LineMap, MovesWithTheMap) {
  std::vector<PosedCloud> scans(Scans().begin(), Scans().begin() + 3);
  const LineMap map = MakeLineMap(scans);
  const Pose2 T_new_map{2.0, {30.0, -70.0}};
  for (PosedCloud& scan : scans) scan.T_map_laser = ToPose3(T_new_map) * scan.T_map_laser;
  const LineMap moved = MakeLineMap(scans);
  ASSERT_EQ(moved.lines.size(), map.lines.size());
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    EXPECT_LT((moved.lines[i].from_map - T_new_map * map.lines[i].from_map).norm(), 1e-8);
    EXPECT_LT((moved.lines[i].to_map - T_new_map * map.lines[i].to_map).norm(), 1e-8);
    EXPECT_EQ(moved.lines[i].scans, map.lines[i].scans);
  }
}

TEST(LineMap, IsDrawnInLayersPerScanAndClass) {
  std::vector<PosedCloud> scans(Scans().begin(), Scans().begin() + 2);
  scans[0].name = scans[1].name = "a/b 0.3d";
  scans.push_back({"empty", {}, {}});
  const LineMap map = MakeLineMap(scans);
  const Drawing drawing = DrawingOf(map);
  ASSERT_EQ(drawing.layers.size(), 3U);
  EXPECT_EQ(drawing.layers[0].name, "points_a_b_0_3d");
  EXPECT_EQ(drawing.layers[1].name, "points_a_b_0_3d-2");
  EXPECT_EQ(drawing.layers[2].name, "lines");
  EXPECT_EQ(drawing.layers[0].points.size(), map.slices[0].points_map.size());
  EXPECT_EQ(drawing.layers[2].lines.size(), map.lines.size());
}

TEST(ScanLayers, HoldThePointsInTheMap) {
  const std::vector<PosedCloud> scans{{"empty", {}, {}}, Scans()[1]};
  const std::vector<DrawingLayer> layers = ScanLayers(scans);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_EQ(layers[0].name, "scan_scan");
  EXPECT_EQ(layers[0].points, Transformed(scans[1].T_map_laser, scans[1].cloud_laser).positions);
  EXPECT_FALSE(ScanColor(0) == ScanColor(1));
}

TEST(LayerNames, AreLegalAndDiffer) {
  const std::vector<std::string> names{"a",       "A", "a", "", std::string(40, 'x'), std::string(41, 'x'),
                                       "\xc3\xa4"};
  EXPECT_THAT(LayerNames("p-", names),
              ElementsAre("p-a", "p-A-2", "p-a-3", "p-", "p-" + std::string(29, 'x'),
                          "p-" + std::string(27, 'x') + "-2", "p-__"));
  EXPECT_THAT(ErrorOf([&] { LayerNames("no blanks", names); }),
              HasSubstr("cannot begin the names of layers"));
}

TEST(HorizontalSlice, HoldsThePointsAtItsHeight) {
  PosedCloud scan;
  scan.name = "one";
  scan.cloud_laser.positions = {{1.0, 0.0, 0.5}, {2.0, 0.0, 0.515}, {3.0, 0.0, 0.53}, {4.0, 1.0, 0.485}};
  scan.T_map_laser = ToPose3(Pose2{RadFromDeg(90.0), {10.0, 20.0}});
  scan.T_map_laser.translation.z() = 1.0;
  const HorizontalSlice slice = SliceAt(scan, {});
  ASSERT_EQ(slice.points_map.size(), 3U);
  EXPECT_TRUE(slice.points_map[0].isApprox(Eigen::Vector2d(10.0, 21.0), 1e-12));
  EXPECT_TRUE(slice.points_map[2].isApprox(Eigen::Vector2d(9.0, 24.0), 1e-12));
  EXPECT_NEAR(slice.T_map_scan.angle, RadFromDeg(90.0), 1e-12);
  scan.cloud_laser.positions[1].z() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ErrorOf([&] { SliceAt(scan, {}); }), HasSubstr("point 1 of scan 'one' has a coordinate"));
  EXPECT_THAT(ErrorOf([&] { SliceAt(scan, {.half_thickness = 0.0}); }), HasSubstr("slice.half_thickness"));
}

/// A line of points every 5 cm, with its moments, from right to left.
MapLine LineAt(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::size_t scan = 0) {
  MapLine line{from, to, {}, 0, {scan}};
  std::vector<Eigen::Vector2d> points;
  for (double s = 0.0; s <= 1.0; s += 0.05 / (to - from).norm()) points.push_back(from + s * (to - from));
  std::vector<std::size_t> indices(points.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  line.moments_map = Gather({points, indices, std::vector<double>(points.size(), 1e4)});
  line.points = points.size();
  return line;
}

TEST(MergeLines, UnitesWhatCoincides) {
  const std::vector<MapLine> lines{LineAt({0, 0}, {2, 0}, 3), LineAt({1.5, 0.02}, {4, 0.02}, 1),
                                   LineAt({4.4, 0.01}, {5, 0.01}, 3)};
  const std::vector<MapLine> merged = MergeLines(lines, {});
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_NEAR(merged[0].from_map.x(), 0.0, 0.01);
  EXPECT_NEAR(merged[0].to_map.x(), 5.0, 0.01);
  EXPECT_GT(merged[0].from_map.y(), -0.01);
  EXPECT_LT(merged[0].to_map.y(), 0.03);
  EXPECT_THAT(merged[0].scans, ElementsAre(1U, 3U));
  EXPECT_EQ(merged[0].points, lines[0].points + lines[1].points + lines[2].points);
  EXPECT_LT(merged[0].Rms(), 0.01);
}

TEST(MergeLines, KeepsApartWhatIsNotOne) {
  const MapLine wall = LineAt({0, 0}, {2, 0});
  EXPECT_TRUE(Coincide(wall, LineAt({0.5, 0.04}, {2.5, 0.04}), {}));
  EXPECT_FALSE(Coincide(wall, LineAt({2, 0.01}, {0, 0.01}), {}));      // the other face of a thin wall
  EXPECT_FALSE(Coincide(wall, LineAt({0.5, 0.06}, {2.5, 0.06}), {}));  // a step
  EXPECT_FALSE(Coincide(wall, LineAt({2.6, 0}, {4, 0}), {}));          // beyond a door
  EXPECT_FALSE(Coincide(wall, LineAt({2, 0}, {2, 1}), {}));            // around the corner
  EXPECT_FALSE(Coincide(wall, LineAt({1, 0}, {1.2, 0.048}), {}));      // short, and askew by 13 deg
  EXPECT_EQ(MergeLines({wall, LineAt({2, -0.1}, {0, -0.1}), LineAt({2.6, 0}, {4, 0})}, {}).size(), 3U);
  EXPECT_TRUE(MergeLines({}, {}).empty());
}

TEST(MergeLines, LeavesNoTwoThatCoincide) {
  RandomStream stream = NamedStream(7, "merge_lines");
  std::vector<MapLine> lines;
  for (std::size_t i = 0; i < 150; ++i) {
    const Eigen::Vector2d from(DrawUniform(stream, 0.0, 4.0),
                               0.1 * std::floor(DrawUniform(stream, 0.0, 5.0)));
    const double length = DrawUniform(stream, 0.2, 2.0);
    lines.push_back(
        LineAt(from, from + length * Eigen::Vector2d(1.0, DrawUniform(stream, -0.02, 0.02)), i));
  }
  const std::vector<MapLine> merged = MergeLines(lines, {});
  std::size_t points = 0, points_before = 0;
  for (const MapLine& line : lines) points_before += line.points;
  for (std::size_t i = 0; i < merged.size(); ++i) {
    points += merged[i].points;
    for (std::size_t k = i + 1; k < merged.size(); ++k) EXPECT_FALSE(Coincide(merged[i], merged[k], {}));
  }
  EXPECT_EQ(points, points_before);
  EXPECT_LT(merged.size(), 40U);
}

}  // namespace
}  // namespace ariadne::slam
