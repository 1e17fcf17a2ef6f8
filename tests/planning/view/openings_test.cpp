#include "planning/view/openings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace ariadne::planning {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// A square of 4 m whose edges are seen as told.
LabelledRing Square(bool bottom, bool right, bool top, bool left) {
  return {{{0, 0}, bottom}, {{4, 0}, right}, {{4, 4}, top}, {{0, 4}, left}};
}

TEST(Openings, SumUnseenEdgesInARow) {
  const std::vector<LabelledPolygon> area{{Square(true, false, false, true), {}}};
  EXPECT_THAT(Openings(area), ElementsAre(0.0, 8.0, 8.0, 0.0));
}

TEST(Openings, GoRoundTheEndOfARing) {
  const std::vector<LabelledPolygon> area{{Square(false, true, true, false), {}}};
  EXPECT_THAT(Openings(area), ElementsAre(8.0, 0.0, 0.0, 8.0));
}

TEST(Openings, OfARingWithoutSeenEdgesAreItsLength) {
  const std::vector<LabelledPolygon> area{{Square(false, false, false, false), {}}};
  EXPECT_THAT(Openings(area), ElementsAre(16.0, 16.0, 16.0, 16.0));
}

TEST(Openings, DoNotDependOnWhereARingBegins) {
  LabelledRing ring{{{0, 0}, false}, {{1, 0}, true}, {{3, 0}, false}, {{3, 2}, false}, {{1, 3}, true}};
  const std::vector<double> first = Openings(std::vector<LabelledPolygon>{{ring, {}}});
  std::ranges::rotate(ring, ring.begin() + 3);
  std::vector<double> second = Openings(std::vector<LabelledPolygon>{{ring, {}}});
  std::ranges::rotate(second, second.begin() + 2);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_THAT(second[i], DoubleNear(first[i], 1e-12));
}

TEST(Openings, OfHolesFollowThoseOfTheOutline) {
  const std::vector<LabelledPolygon> area{
      {Square(true, true, true, false), {{{{1, 1}, false}, {{1, 2}, true}, {{2, 1}, true}}}},
      {Square(false, true, true, true), {}}};
  EXPECT_THAT(Openings(area), ElementsAre(0, 0, 0, 4, 1, 0, 0, 4, 0, 0, 0));
}

}  // namespace
}  // namespace ariadne::planning
