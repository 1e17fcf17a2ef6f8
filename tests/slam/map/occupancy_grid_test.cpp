#include "slam/map/occupancy_grid.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/random.h"
#include "slam/map/grid_beam.h"
#include "slam/map/grid_votes.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using testing::HasSubstr;

/// Points on a wall at x = distance before the laser, 1 m above the floor, from 2 m right to 2 m left of
/// it.
PosedCloud ScanOfWall(double distance, double low = 0.5, double high = 1.5) {
  PosedCloud scan;
  scan.name = "wall";
  for (double y = -1.99; y < 2.0; y += 0.02) {
    for (double z = low; z <= high; z += 0.05)
      scan.cloud_laser.positions.emplace_back(distance, y, z - 1.0);
  }
  scan.T_map_laser.translation.z() = 1.0;
  return scan;
}

Occupancy At(const OccupancyGrid& grid, double x, double y) {
  const Eigen::Array2d cell = ((Eigen::Array2d(x, y) - grid.origin_map.array()) / grid.resolution).floor();
  return grid.At(static_cast<std::size_t>(cell.x()), static_cast<std::size_t>(cell.y()));
}

TEST(OccupancyGrid, IsFreeUpToTheWallAndUnknownBehind) {
  const PosedCloud scan = ScanOfWall(3.02);
  const OccupancyGrid grid = MakeOccupancyGrid({&scan, 1}, {.resolution = 0.1});
  ASSERT_EQ(grid.log_odds.size(), grid.columns * grid.rows);
  EXPECT_EQ(At(grid, 0.0, 0.0), Occupancy::kFree);
  EXPECT_EQ(At(grid, 1.5, 0.5), Occupancy::kFree);
  EXPECT_EQ(At(grid, 2.95, 0.0), Occupancy::kFree);
  for (double y = -1.95; y < 2.0; y += 0.1) EXPECT_EQ(At(grid, 3.05, y), Occupancy::kOccupied) << y;
  EXPECT_EQ(At(grid, 3.15, 0.0), Occupancy::kUnknown);
  EXPECT_EQ(At(grid, 0.5, 1.5), Occupancy::kUnknown);  // beside the beams
}

TEST(OccupancyGrid, SeesFreeSpaceOverTheFloorButNoObstacleInIt) {
  PosedCloud scan;
  for (double x = 1.0; x < 3.0; x += 0.02) scan.cloud_laser.positions.emplace_back(x, 0.001, -1.0);
  scan.T_map_laser.translation.z() = 1.0;
  const OccupancyGrid grid =
      MakeOccupancyGrid({&scan, 1}, {.resolution = 0.1, .min_height = 0.1, .max_height = 0.5});
  EXPECT_EQ(At(grid, 0.85, 0.05), Occupancy::kFree);
  EXPECT_EQ(At(grid, 2.65, 0.05), Occupancy::kFree);  // 0.1 m over the floor at x = 2.7
  for (const float odds : grid.log_odds) EXPECT_LE(odds, 0.0F);
  const Eigen::Vector2d low = grid.origin_map;
  EXPECT_NEAR(low.x(), 0.4, 1e-9);  // the first beam is 0.5 m high at x = 0.5; a cell of frame
}

TEST(OccupancyGrid, ForgetsWhatIsGoneAndKeepsWhatBeamsPassOver) {
  const PosedCloud wall = ScanOfWall(3.02), far = ScanOfWall(5.02);
  const std::vector<PosedCloud> gone{wall, far, far, far};
  EXPECT_EQ(At(MakeOccupancyGrid(gone, {.resolution = 0.1}), 3.05, 0.05), Occupancy::kFree);
  const std::vector<PosedCloud> stays{far, wall, wall, far, far, far};
  EXPECT_EQ(At(MakeOccupancyGrid(stays, {.resolution = 0.1}), 3.05, 0.05), Occupancy::kOccupied);
  const PosedCloud table = ScanOfWall(3.02, 0.7, 0.72), over = ScanOfWall(5.02, 1.0, 1.5);
  const std::vector<PosedCloud> seen_over{table, over, over, over, over, over, over};
  EXPECT_EQ(At(MakeOccupancyGrid(seen_over, {.resolution = 0.1}), 3.05, 0.05), Occupancy::kOccupied);
}

TEST(OccupancyGrid, ShowsWhatTheLastScanMetIfItMayBelieveItsMissesLess) {
  const PosedCloud wall = ScanOfWall(3.02), far = ScanOfWall(5.02);
  const std::vector<PosedCloud> new_wall{far, far, far, far, far, wall};
  EXPECT_EQ(At(MakeOccupancyGrid(new_wall, {.resolution = 0.1}), 3.05, 0.05), Occupancy::kFree);
  const OccupancyGridOptions wary{.resolution = 0.1, .most_against = 0.8};
  EXPECT_EQ(At(MakeOccupancyGrid(new_wall, wary), 3.05, 0.05), Occupancy::kOccupied);
}

/// Rows of beams from 0.95 m above the floor onto a table's top, 1.5 to 2.37 m ahead and 0.73 m high, and
/// beside and behind it onto the floor. The last row on it ends 14 cm before its edge.
PosedCloud ScanOfTable() {
  PosedCloud scan;
  scan.name = "table";
  scan.T_map_laser.translation.z() = 0.95;
  for (int row = 1; row < 100; ++row) {
    const double slope = std::tan(row * 0.47 * std::numbers::pi / 180.0);
    for (double side = -0.5; side < 0.5; side += 0.01) {  // per metre ahead
      const double to_top = 0.22 / slope, to_floor = 0.95 / slope;
      const bool on_table = to_top > 1.5 && to_top < 2.37;
      const double x = on_table ? to_top : to_floor;
      if (x < 12.0) scan.cloud_laser.positions.emplace_back(x, side * x, -slope * x);
    }
  }
  return scan;
}

TEST(OccupancyGrid, LetsATableGoOnToWhereABeamHasPassed) {
  const PosedCloud scan = ScanOfTable();
  OccupancyGridOptions options{.resolution = 0.03, .max_height = 1.2};
  EXPECT_EQ(At(MakeOccupancyGrid({&scan, 1}, options), 2.22, 0.01), Occupancy::kOccupied);
  EXPECT_EQ(At(MakeOccupancyGrid({&scan, 1}, options), 2.35, 0.01), Occupancy::kFree)
      << "no point, no table";
  options.doubt = 0.15;
  const OccupancyGrid wary = MakeOccupancyGrid({&scan, 1}, options);
  EXPECT_EQ(At(wary, 2.35, 0.01), Occupancy::kOccupied);
  EXPECT_EQ(At(wary, 2.65, 0.01), Occupancy::kFree) << "a beam has passed lower";
  EXPECT_EQ(At(wary, 1.44, 0.01), Occupancy::kFree) << "before the table";
  options.doubt = 1.0;
  EXPECT_EQ(At(MakeOccupancyGrid({&scan, 1}, options), 2.65, 0.01), Occupancy::kFree);
}

/// From 95 cm, the floor around a thing that is as high as the lowest things count: its one point.
TEST(OccupancyGrid, LetsNoThresholdGoOnOverTheFloorThatIsSeen) {
  PosedCloud scan;
  scan.T_map_laser.translation.z() = 0.95;
  for (double x = 1.0; x < 3.0; x += 0.02) {
    for (double y = -0.5; y < 0.5; y += 0.02) scan.cloud_laser.positions.emplace_back(x, y, -0.95);
  }
  scan.cloud_laser.positions.emplace_back(2.0, 0.01, -0.845);
  const OccupancyGridOptions options{.resolution = 0.03, .max_height = 1.2, .doubt = 0.24};
  const OccupancyGrid grid = MakeOccupancyGrid({&scan, 1}, options);
  EXPECT_EQ(At(grid, 2.0, 0.01), Occupancy::kOccupied);
  EXPECT_EQ(At(grid, 2.0, 0.13), Occupancy::kFree);
  EXPECT_EQ(At(grid, 1.85, 0.01), Occupancy::kFree);
}

TEST(GridVotes, AddUpToTheGridOfAllScans) {
  const OccupancyGridOptions options{.resolution = 0.1};
  const std::vector<PosedCloud> scans{ScanOfWall(3.02), ScanOfWall(5.02, 0.2, 0.8), ScanOfWall(2.0)};
  std::vector<GridPart> parts;
  CellBox box;
  for (const PosedCloud& scan : scans) {
    parts.push_back(MakeGridPart(scan, options));
    box.extend(parts.back().box);
  }
  GridVotes votes(box, options);
  for (const GridPart& part : parts) votes.Meet(part);
  for (const GridPart& part : parts) votes.Vote(part);
  const OccupancyGrid grid = std::move(votes).Finish(), whole = MakeOccupancyGrid(scans, options);
  EXPECT_EQ(grid.log_odds, whole.log_odds);
  EXPECT_EQ(grid.origin_map, whole.origin_map);
}

TEST(OccupancyGrid, CutsLongBeamsAndBoundsTheOdds) {
  const PosedCloud scan = ScanOfWall(3.02);
  const OccupancyGrid cut = MakeOccupancyGrid({&scan, 1}, {.resolution = 0.1, .max_range = 2.0});
  EXPECT_EQ(At(cut, 1.85, 0.05), Occupancy::kFree);
  for (const float odds : cut.log_odds) EXPECT_LE(odds, 0.0F);
  const std::vector<PosedCloud> often(20, scan);
  for (const float odds : MakeOccupancyGrid(often, {}).log_odds) EXPECT_LE(std::abs(odds), 3.5F);
}

TEST(OccupancyGrid, MovesWithTheMap) {
  std::vector<PosedCloud> scans{ScanOfWall(3.02), ScanOfWall(5.02, 0.2, 0.8)};
  const OccupancyGrid grid = MakeOccupancyGrid(scans, {.resolution = 0.125});
  for (PosedCloud& scan : scans) scan.T_map_laser.translation += Eigen::Vector3d(-12.5, 100.0, 0.0);
  const OccupancyGrid moved = MakeOccupancyGrid(scans, {.resolution = 0.125});
  EXPECT_EQ(moved.log_odds, grid.log_odds);
  EXPECT_EQ(moved.origin_map, grid.origin_map + Eigen::Vector2d(-12.5, 100.0));
}

TEST(OccupancyGrid, RefusesWhatIsNoMap) {
  const auto error = [](const PosedCloud& scan, const OccupancyGridOptions& options) {
    return ErrorOf([&] { MakeOccupancyGrid({&scan, 1}, options); });
  };
  PosedCloud scan = ScanOfWall(3.0);
  EXPECT_THAT(ErrorOf([] { MakeOccupancyGrid({}); }),
              HasSubstr("no beam of the scans is between the heights"));
  EXPECT_THAT(error(scan, {.min_height = 5.0, .max_height = 6.0}), HasSubstr("no beam of the scans"));
  EXPECT_THAT(error(scan, {.min_height = 2.0, .max_height = 1.0}), HasSubstr("above grid.max_height"));
  EXPECT_THAT(error(scan, {.resolution = 0.0}), HasSubstr("grid.resolution is 0 m, but must be"));
  scan.cloud_laser.positions[7] = {1e6, 1e6, 0.0};
  EXPECT_THAT(error(scan, {}), HasSubstr("is too large; use larger cells, or limit the range"));
  scan.cloud_laser.positions[7].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error(scan, {}), HasSubstr("point 7 of scan 'wall' has a coordinate that is NaN"));
  scan.T_map_laser.translation.y() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error(scan, {}), HasSubstr("the pose of scan 'wall' is NaN or infinite"));
}

TEST(ForEachCell, GoesFromCellToNeighbourAlongTheLine) {
  RandomStream stream = NamedStream(1, "cells");
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Vector2d from(DrawUniform(stream, -9.0, 9.0), DrawUniform(stream, -9.0, 9.0));
    Eigen::Vector2d to(DrawUniform(stream, -9.0, 9.0), DrawUniform(stream, -9.0, 9.0));
    if (trial % 4 == 0) to.x() = from.x();
    if (trial % 8 == 0) to.y() = std::floor(to.y());  // on a border
    std::vector<Cell> cells;
    double before = 0.0;
    ForEachCell(from, to, [&](const Cell& cell, double enter, double leave) {
      EXPECT_EQ(enter, before);
      EXPECT_LE(enter, leave);
      const Eigen::Array2d middle = (from + 0.5 * (enter + leave) * (to - from)).array();
      EXPECT_TRUE((middle >= cell.cast<double>() - 1e-9).all() &&
                  (middle <= cell.cast<double>() + 1.0 + 1e-9).all());
      if (!cells.empty()) {
        EXPECT_EQ((cell - cells.back()).abs().sum(), 1);
      }
      cells.push_back(cell);
      before = leave;
    });
    EXPECT_EQ(before, 1.0);
    EXPECT_TRUE((cells.front() == from.array().floor().cast<int>()).all());
    EXPECT_TRUE((cells.back() == to.array().floor().cast<int>()).all());
  }
}

}  // namespace
}  // namespace ariadne::slam
