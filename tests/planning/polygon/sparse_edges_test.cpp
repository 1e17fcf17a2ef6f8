#include "planning/polygon/sparse_edges.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "slam/geometry/pose2.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;

/// A room of 20 m x 8 m, all of it seen, and one scan at a place of it.
LabelledPolygon Hall() {
  return {{{{0.0, 0.0}, true}, {{20.0, 0.0}, true}, {{20.0, 8.0}, true}, {{0.0, 8.0}, true}}, {}};
}

std::vector<SightedLine> LinesFrom(const Vector2d& scanner_map) {
  std::vector<SightedLine> lines;
  const LabelledRing ring = Hall().outer;
  for (std::size_t i = 0; i < ring.size(); ++i)
    lines.push_back({ring[i].p_map, ring[(i + 1) % ring.size()].p_map, scanner_map});
  return lines;
}

SparseEdgeOptions Spacing(double max_spacing) {
  SparseEdgeOptions options;
  options.max_spacing = max_spacing;
  return options;
}

double Area(const LabelledPolygon& polygon) { return slam::Area(ToPolygon2(polygon)); }

TEST(WithSparseUnseen, LeavesWhatBeamsHitDensely) {
  const LabelledPolygon hall = Hall();
  const std::vector<SightedLine> lines = LinesFrom({4.0, 4.0});
  const LabelledPolygon relabelled = WithSparseUnseen({&hall, 1}, lines, Spacing(0.15)).front();
  EXPECT_NEAR(Area(relabelled), 160.0, 1e-9);
  // A beam of 1 deg makes r^2 / h steps of 0.01745 on a wall h away: 0.15 m at r = 5.86 m where h = 4 m,
  // and on the walls across it at r = 8.59 m (none at 4 m is farther than 5.7 m), none at 16 m.
  const double along = std::sqrt(0.15 / (std::numbers::pi / 180.0) * 4.0 - 16.0);
  EXPECT_NEAR(SeenLength(relabelled), 2.0 * (4.0 + along) + 8.0, 2 * 0.25);
  EXPECT_NEAR(SeenLength(relabelled) + UnseenLength(relabelled), 56.0, 1e-9);
}

TEST(WithSparseUnseen, NeverSeesWhatWasUnseenAndTakesTheBestOfAllScans) {
  LabelledPolygon hall = Hall();
  hall.outer[1].seen = false;  // the wall at x = 20 m
  std::vector<SightedLine> lines = LinesFrom({4.0, 4.0});
  const double one = SeenLength(WithSparseUnseen({&hall, 1}, lines, Spacing(0.15)).front());
  const std::vector<SightedLine> more = LinesFrom({16.0, 4.0});
  lines.insert(lines.end(), more.begin(), more.end());
  const LabelledPolygon both = WithSparseUnseen({&hall, 1}, lines, Spacing(0.15)).front();
  EXPECT_GT(SeenLength(both), one + 10.0);
  EXPECT_GE(UnseenLength(both), 8.0 - 1e-9);
}

TEST(WithSparseUnseen, NeedsALineThatIsAtTheEdge) {
  const LabelledPolygon hall = Hall();
  std::vector<SightedLine> lines = LinesFrom({4.0, 4.0});
  for (SightedLine& line : lines) line.from_map.y() += 0.5, line.to_map.y() += 0.5;
  const LabelledPolygon relabelled = WithSparseUnseen({&hall, 1}, lines, Spacing(0.15)).front();
  EXPECT_NEAR(SeenLength(relabelled), 7.5, 0.5);  // only the wall along which the lines were shifted
}

TEST(WithSparseUnseen, NeedsALineSeenFromTheFreeSide) {
  const LabelledPolygon hall = Hall();
  const std::vector<SightedLine> behind =
      LinesFrom({10.0, -1.0});  // as through a thin wall, from next door
  const LabelledPolygon relabelled = WithSparseUnseen({&hall, 1}, behind, Spacing(0.15)).front();
  for (const LabelledCorner& corner : relabelled.outer) {
    if (corner.p_map.y() == 0.0 && corner.p_map.x() < 20.0) EXPECT_FALSE(corner.seen) << corner.p_map.x();
  }
}

TEST(WithSparseUnseen, IsTheSameInAnyFrameAndNothingWithoutASpacing) {
  const LabelledPolygon hall = Hall();
  const std::vector<SightedLine> lines = LinesFrom({3.0, 2.0});
  const LabelledPolygon untouched = WithSparseUnseen({&hall, 1}, lines, {}).front();
  EXPECT_EQ(SeenLength(untouched), 56.0);
  EXPECT_EQ(untouched.outer.size(), 4U);
  const double seen = SeenLength(WithSparseUnseen({&hall, 1}, lines, Spacing(0.2)).front());
  const slam::Pose2 T_other_map{0.7, {-30.0, 12.0}};
  LabelledPolygon moved = hall;
  for (LabelledCorner& corner : moved.outer) corner.p_map = T_other_map * corner.p_map;
  std::vector<SightedLine> moved_lines;
  for (const SightedLine& line : lines)
    moved_lines.push_back(
        {T_other_map * line.from_map, T_other_map * line.to_map, T_other_map * line.scanner_map});
  EXPECT_NEAR(SeenLength(WithSparseUnseen({&moved, 1}, moved_lines, Spacing(0.2)).front()), seen, 1e-9);
  EXPECT_THAT(ErrorOf([&] {
                WithSparseUnseen({&hall, 1}, lines, Spacing(-1.0));
              }),
              testing::HasSubstr("sparse.max_spacing is -1 m"));
}

}  // namespace
}  // namespace ariadne::planning
