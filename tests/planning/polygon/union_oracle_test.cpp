#include "tests/planning/polygon/union_oracle.h"

#include <gtest/gtest.h>

#include "tests/planning/polygon/check_union.h"
#include "tests/planning/polygon/random_polygons.h"

namespace ariadne::planning {
namespace {

constexpr std::array kSeen{true, true, true, true};
constexpr std::array kUnseen{false, false, false, false};

TEST(UnionOracle, KnowsWhatCanBeCountedByHand) {
  const LabelledPolygon room = Rectangle({0.0, 0.0}, {4.0, 3.0}, kUnseen);
  const auto lengths = [&](const LabelledPolygon& other) {
    const auto boundary = oracle::Boundary(std::vector{room, other});
    return std::pair(LengthOf(boundary, true), LengthOf(boundary, false));
  };
  const auto near = [](std::pair<double, double> counted, double seen, double unseen) {
    EXPECT_NEAR(counted.first, seen, 1e-9);
    EXPECT_NEAR(counted.second, unseen, 1e-9);
  };
  near(lengths(Rectangle({1.0, 0.0}, {3.0, 2.0}, kSeen)), 2.0, 12.0);  // on an edge, from within
  near(lengths(Rectangle({1.0, 3.0}, {3.0, 4.0}, kSeen)), 4.0, 12.0);  // on an edge, from outside
  near(lengths(Rectangle({1.0, 1.0}, {3.0, 2.0}, kSeen)), 0.0, 14.0);  // within
  near(lengths(Rectangle({3.0, 2.0}, {5.0, 5.0}, kSeen)), 8.0, 12.0);  // across a corner
  near(lengths(Rectangle({4.0, 3.0}, {5.0, 5.0}, kSeen)), 6.0, 14.0);  // touching in a corner
  near(lengths(Rectangle({0.0, 0.0}, {4.0, 3.0}, kSeen)), 14.0, 0.0);  // the same
}

// Lengths with each label agree, and every stretch of either boundary is in the other: nothing is missing.
// 100,000 of them are in tests/planning/polygon/many.
TEST(LabelledUnion, AgreesWithAnIndependentOracle) { CheckRandomUnions(1000, 3); }

}  // namespace
}  // namespace ariadne::planning
