#include "slam/matching/map_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/support/brute_force.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MapScan ScanOf(const std::vector<Eigen::Vector3d>& positions, const Pose3& T_map_laser = {}) {
  return {"scan", {positions, {}, {}, {}}, KdTree(positions), T_map_laser, true};
}

/// Points on the x axis, a metre apart, from `first` on.
MapScan Row(int first, int count) {
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i < count; ++i) positions.emplace_back(first + i, 0.0, 0.0);
  return ScanOf(positions);
}

/// One row each, of ten points.
std::vector<MapScan> RowsFrom(const std::vector<int>& firsts) {
  std::vector<MapScan> scans;
  for (const int first : firsts) scans.push_back(Row(first, 10));
  return scans;
}

TEST(CountOverlap, CountsDataPointsWithAModelPointWithinTheGate) {
  RandomStream stream = NamedStream(1, "map_scan_test");
  for (int i = 0; i < 10; ++i) {
    const MapScan model = ScanOf(DrawCloud(stream, 200, 1.0), DrawMotion(stream, 5.0, 3.0));
    const MapScan data =
        ScanOf(DrawCloud(stream, 150, 1.0), DrawMotion(stream, 0.5, 3.0) * model.T_map_laser);
    std::size_t expected = 0;
    for (const Eigen::Vector3d& d : data.points_laser.positions) {
      const Eigen::Vector3d p = model.T_map_laser.Inverse() * (data.T_map_laser * d);
      expected += NearestOfAll(model.points_laser.positions, p, 0.2).index != kNoPoint;
    }
    EXPECT_EQ(CountOverlap(model, data, 0.2, Parallel(2)), expected);
  }
}

TEST(CountOverlap, AsksForEachPointOfTheData) {
  const MapScan few = Row(0, 2), many = ScanOf(std::vector<Eigen::Vector3d>(7, {0.1, 0.0, 0.0}));
  EXPECT_EQ(CountOverlap(few, many, 0.5, Parallel(1)), 7u);
  EXPECT_EQ(CountOverlap(many, few, 0.5, Parallel(1)), 1u);
}

/// A wall of 2 m x 2 m as a scanner sees it that stands 1.5 m from its surface at x = `face` [m], on the
/// side of `side`; the laser turned by some angle.
MapScan WallFrom(double side, double face, double turned) {
  std::vector<Eigen::Vector3d> positions;
  const Pose3 T_map_laser{ExpSo3({0.0, 0.0, turned}), {face + 1.5 * side, 0.0, 1.0}};
  for (int y = -10; y <= 10; ++y) {
    for (int z = 0; z <= 20; ++z)
      positions.push_back(T_map_laser.Inverse() * Eigen::Vector3d(face, 0.1 * y, 0.1 * z));
  }
  MapScan scan = ScanOf(positions, T_map_laser);
  RequireSurfaces(scan, 10, Parallel(1));
  return scan;
}

TEST(CountOverlap, OneSidedTellsTheSidesOfAThinWall) {
  const double thickness = 0.12, gate = 0.2;
  const MapScan here = WallFrom(-1.0, 0.0, 0.3), there = WallFrom(1.0, thickness, -2.0);
  const MapScan here_too = WallFrom(-1.0, 0.03, 1.1);
  const std::size_t all = here.points_laser.size();
  EXPECT_EQ(CountOverlap(here, there, gate, Parallel(1), false), all);
  EXPECT_EQ(CountOverlap(here, there, gate, Parallel(1), true), 0u);
  EXPECT_EQ(CountOverlap(there, here, gate, Parallel(2), true), 0u);
  EXPECT_EQ(CountOverlap(here, here_too, gate, Parallel(1), true), all);
}

TEST(CountOverlap, OneSidedLetsPointsWithoutSurfaceCount) {
  MapScan row = Row(0, 10);  // points on a line have no normal
  RequireSurfaces(row, 5, Parallel(1));
  EXPECT_EQ(CountOverlap(row, row, 0.5, Parallel(1), true), 10u);
}

TEST(FindOverlapping, WantsMoreThanTheGivenPairs) {
  const std::vector<MapScan> scans = RowsFrom({0, 5, 8});
  const auto overlapping = [&](std::size_t current, std::size_t min_pairs) {
    return FindOverlapping(scans, current, min_pairs, 0.5, Parallel(1));
  };
  EXPECT_THAT(overlapping(0, 0), ElementsAre(1, 2));
  EXPECT_THAT(overlapping(0, 1), ElementsAre(1, 2));
  EXPECT_THAT(overlapping(0, 2), ElementsAre(1)) << "2 pairs are not more than 2";
  EXPECT_THAT(overlapping(0, 4), ElementsAre(1));
  EXPECT_THAT(overlapping(0, 5), IsEmpty());
  EXPECT_THAT(overlapping(1, 4), ElementsAre(0, 2));
}

TEST(FindOverlapping, PassesOverScansThatAreNotRegistered) {
  std::vector<MapScan> scans = RowsFrom({0, 0, 0});
  scans[1].registered = false;
  EXPECT_THAT(FindOverlapping(scans, 2, 3, 0.5, Parallel(1)), ElementsAre(0));
}

TEST(UnionInMap, HasThePointsOfItsMembersInTheMap) {
  RandomStream stream = NamedStream(1, "map_scan_test/union");
  std::vector<MapScan> scans;
  for (int i = 0; i < 3; ++i) {
    scans.push_back(ScanOf(DrawCloud(stream, 20, 1.0), DrawMotion(stream, 5.0, 3.0)));
  }
  const AlignModel both = UnionInMap(scans, {0, 2});
  ASSERT_EQ(both.tree.points().size(), 40u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_THAT(both.tree.points()[i],
                NearMatrix(scans[0].T_map_laser * scans[0].points_laser.positions[i], 1e-14));
    EXPECT_THAT(both.tree.points()[20 + i],
                NearMatrix(scans[2].T_map_laser * scans[2].points_laser.positions[i], 1e-14));
  }
}

TEST(UnionInMap, TurnsTheSurfacesOfItsMembers) {
  RandomStream stream = NamedStream(1, "map_scan_test/surfaces");
  std::vector<Eigen::Vector3d> floor = DrawCloud(stream, 100, 1.0);
  for (Eigen::Vector3d& p : floor) p.z() = 0.0;
  std::vector<MapScan> scans;
  for (int i = 0; i < 2; ++i) {
    scans.push_back(ScanOf(floor, DrawMotion(stream, 5.0, 3.0)));
    RequireSurfaces(scans.back(), 10, Parallel(1));
  }
  const AlignModel model = UnionInMap(scans, {0, 1});
  ASSERT_EQ(model.surfaces.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i) {
    const Eigen::Vector3d up = scans[i / 100].T_map_laser.rotation * Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(std::abs(model.surfaces[i].normal.dot(up)), 1.0, 1e-12);
    EXPECT_EQ(model.surfaces[i].radius, scans[i / 100].surfaces_laser[i % 100].radius);
  }
  scans[1].surfaces_laser.clear();
  EXPECT_THAT(UnionInMap(scans, {0, 1}).surfaces, IsEmpty()) << "all points or none";
}

}  // namespace
}  // namespace ariadne::slam
