#include "planning/path/free_space.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "planning/path/distance_transform.h"
#include "tests/planning/path/random_rooms.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

TEST(DistanceTransform, AgreesWithAllPairs) {
  RandomStream stream = NamedStream(1, "test");
  for (int round = 0; round < 30; ++round) {
    const int columns = 1 + static_cast<int>(DrawUniform(stream, 0.0, 20.0));
    const int rows = 1 + static_cast<int>(DrawUniform(stream, 0.0, 20.0));
    std::vector<bool> marked(static_cast<std::size_t>(columns * rows));
    for (auto cell : marked) cell = DrawUniform(stream, 0.0, 1.0) < 0.05;
    const std::vector<float> squares = SquaredDistances(marked, columns, rows);
    for (int i = 0; i < columns * rows; ++i) {
      float nearest = std::numeric_limits<float>::infinity();
      for (int j = 0; j < columns * rows; ++j) {
        if (!marked[static_cast<std::size_t>(j)]) continue;
        const int dx = i % columns - j % columns, dy = i / columns - j / columns;
        nearest = std::min(nearest, static_cast<float>(dx * dx + dy * dy));
      }
      EXPECT_EQ(squares[static_cast<std::size_t>(i)], nearest) << columns << " x " << rows << ", " << i;
    }
  }
}

TEST(FreeSpace, NeverOverestimates) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    double worst = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const Eigen::Vector2d p = DrawAround(room.room, stream);
      const double clearance = space.Clearance(p), truth = TrueClearance(room.area, p);
      EXPECT_LE(clearance, truth + 1e-5) << seed << ": " << p.transpose();
      EXPECT_GE(clearance, truth - (truth < 0.9 ? 0.071 : 0.22)) << seed << ": " << p.transpose();
      worst = std::max(worst, truth - clearance);
    }
    EXPECT_GT(worst, 0.05) << "places beside walls have none";
  }
}

TEST(FreeSpace, DiscsAreExactNearWalls) {
  int open = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d p = DrawAround(room.room, stream);
      const double truth = TrueClearance(room.area, p);
      for (const double radius : {0.15, 0.35, 0.9}) {
        if (std::abs(truth - radius) < 1e-4) continue;
        EXPECT_EQ(space.IsFree(p, radius), truth > radius) << seed << ": " << p.transpose();
        open += space.IsFree(p, radius) && space.Clearance(p) < radius;
      }
    }
  }
  EXPECT_GT(open, 50) << "the raster alone would do";
}

TEST(FreeSpace, LosesLittleOfAWall) {
  const std::array area{slam::Polygon2{Box(0.03, 0.04, 6.0, 5.0), {}}};
  for (const double turn : {0.0, 0.3, 0.785398}) {
    const slam::Pose2 T_map_room{turn, {3.0, -2.0}};
    std::array turned = area;
    for (Eigen::Vector2d& p : turned[0].outer) p = T_map_room * p;
    const FreeSpace space(turned);
    for (double x = 1.0; x < 5.0; x += 0.013) {
      const double clearance = space.Clearance(T_map_room * Eigen::Vector2d(x, 0.39));
      EXPECT_GE(clearance, 0.35 - 0.1 * 0.1 / (7.0 * 0.35));
      EXPECT_LE(clearance, 0.35 + 1e-5);
    }
  }
}

TEST(FreeSpace, SeesWhatIsThinnerThanACell) {
  const slam::Ring post{{3.02, 2.02}, {3.02, 2.03}, {3.03, 2.03}, {3.03, 2.02}};
  const slam::Ring wall{{5.011, 0.5}, {5.011, 3.5}, {5.012, 3.5}, {5.012, 0.5}};
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 8.0, 4.0), {post, wall}}};
  const FreeSpace space(area);
  EXPECT_NEAR(space.Clearance({3.02, 1.62}), 0.4, 0.005);
  EXPECT_NEAR(space.Clearance({5.312, 2.0}), 0.3, 0.006);
  EXPECT_FALSE(space.IsWayFree({4.0, 2.0}, {6.0, 2.0}, 0.1));
  EXPECT_FALSE(space.IsWayFree({3.025, 1.0}, {3.025, 3.0}, 0.05));
  EXPECT_TRUE(space.IsWayFree({4.0, 0.6}, {4.0, 3.4}, 0.5));
  EXPECT_EQ(space.CountCrossings({4.0, 2.0}, {6.0, 2.0}), 2);
}

TEST(FreeSpace, KnowsDistancesBeyondExactOnes) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 20.0, 14.0), {}}};
  const FreeSpace space(area);
  EXPECT_LE(space.Clearance({10.0, 7.0}), 7.0);
  EXPECT_GE(space.Clearance({10.0, 7.0}), 7.0 - 0.22);
  FreeSpaceOptions options;
  options.exact_within = 10.0;
  EXPECT_NEAR(FreeSpace(area, options).Clearance({10.0, 7.0}), 7.0, 0.071);
}

TEST(FreeSpace, CellsAndPlacesCorrespond) {
  const PillarRoom room = RandomPillarRoom(3);
  const FreeSpace space(std::span(&room.area, 1));
  for (int row = 0; row < space.rows(); row += 7) {
    for (int column = 0; column < space.columns(); column += 5) {
      const Cell cell{column, row};
      EXPECT_EQ(space.CellOf(space.CentreOf(cell)), cell);
      EXPECT_NEAR(space.ClearanceAt(cell), space.Clearance(space.CentreOf(cell)), 1e-6);
    }
  }
  RandomStream stream = NamedStream(1, "test");
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d p = DrawAround(room.room, stream);
    EXPECT_EQ(space.Contains(p), slam::Contains(room.area, p));
  }
  for (const Eigen::Vector2d& p : room.room) {
    EXPECT_TRUE(space.IsOnRaster(space.CellOf(p)));
    EXPECT_EQ(space.Clearance(p), 0.0);
  }
}

TEST(FreeSpace, SeveralPolygonsAndNone) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 2.0, 2.0), {}},
                        slam::Polygon2{Box(2.1, 0.0, 4.0, 2.0), {}}};
  const FreeSpace space(area);
  EXPECT_TRUE(space.IsFree({1.0, 1.0}, 0.9));
  EXPECT_TRUE(space.IsFree({3.05, 1.0}, 0.9));
  EXPECT_FALSE(space.IsWayFree({1.0, 1.0}, {3.0, 1.0}, 0.0001));
  const FreeSpace nothing({});
  EXPECT_EQ(nothing.columns(), 0);
  EXPECT_EQ(nothing.Clearance({0.0, 0.0}), 0.0);
  EXPECT_FALSE(nothing.Contains({0.0, 0.0}));
}

TEST(FreeSpace, OutsideThereIsNoClearance) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 2.0, 2.0), {}}};
  const FreeSpace space(area);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(-0.05, 1.0), Eigen::Vector2d(2.08, 1.0),
                                   Eigen::Vector2d(1e300, 0.0), Eigen::Vector2d(nan, 1.0)}) {
    EXPECT_EQ(space.Clearance(p), 0.0) << p.transpose();
  }
  EXPECT_FALSE(space.IsWayFree({1.0, 1.0}, {nan, 1.0}, 0.1));
}

TEST(FreeSpace, RefusesWhatIsNoArea) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array bad{slam::Polygon2{{{0.0, 0.0}, {1.0, nan}, {0.0, 1.0}}, {}}};
  EXPECT_EQ(ErrorOf([&] { FreeSpace space(bad); }),
            "the free area has the corner (1, nan), which is no place within 10000000 m");
  const std::array large{slam::Polygon2{Box(0.0, 0.0, 1000.0, 500.0), {}}};
  EXPECT_EQ(ErrorOf([&] { FreeSpace space(large); }),
            "the free area of 1000.0 x 500.0 m has 50030004 cells of 0.1 m, more than 20000000; raise "
            "free_space.resolution or free_space.max_cells");
  FreeSpaceOptions options;
  options.resolution = 0.0;
  EXPECT_NE(ErrorOf([&] { FreeSpace space({}, options); }).find("free_space.resolution"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
