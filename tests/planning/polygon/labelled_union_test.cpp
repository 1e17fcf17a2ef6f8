#include "planning/polygon/labelled_union.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/random.h"
#include "slam/geometry/pose2.h"
#include "tests/planning/polygon/check_union.h"
#include "tests/planning/polygon/random_polygons.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;
constexpr double kHalfCircle = std::numbers::pi;

double SeenLength(const std::vector<LabelledPolygon>& polygons) {
  double length = 0.0;
  for (const LabelledPolygon& polygon : polygons) length += planning::SeenLength(polygon);
  return length;
}

double UnseenLength(const std::vector<LabelledPolygon>& polygons) {
  double length = 0.0;
  for (const LabelledPolygon& polygon : polygons) length += planning::UnseenLength(polygon);
  return length;
}

TEST(LabelledUnion, AnOpeningBetweenWallsInOneLineSurvives) {
  const LabelledPolygon room{{{{0.0, 0.0}, true},
                              {{1.0, 0.0}, false},
                              {{1.9, 0.0}, true},
                              {{4.0, 0.0}, true},
                              {{4.0, 3.0}, true},
                              {{0.0, 3.0}, true}},
                             {}};
  const auto alone = LabelledUnion(std::vector{room}, kExact);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_NEAR(UnseenLength(alone), 0.9, 1e-3);
  EXPECT_NEAR(SeenLength(alone), 13.1, 1e-3);
}

TEST(LabelledUnion, SeenWinsWhereBothLieOnEachOther) {
  const auto unseen = Rectangle({0.0, 0.0}, {4.0, 3.0}, {false, false, false, false});
  const auto seen = Rectangle({1.0, 0.0}, {3.0, 2.0}, {true, true, true, true});
  for (const auto& both : {std::vector{unseen, seen}, std::vector{seen, unseen}}) {
    const auto united = LabelledUnion(both, kExact);
    EXPECT_NEAR(SeenLength(united), 2.0, 1e-3);
    EXPECT_NEAR(UnseenLength(united), 12.0, 1e-3);
  }
}

TEST(LabelledUnion, HolesKeepTheirLabels) {
  const std::vector<LabelledPolygon> around{Rectangle({0.0, 0.0}, {6.0, 2.0}, {true, true, false, true}),
                                            Rectangle({0.0, 4.0}, {6.0, 6.0}, {true, true, true, true}),
                                            Rectangle({0.0, 0.0}, {2.0, 6.0}, {true, true, true, true}),
                                            Rectangle({4.0, 0.0}, {6.0, 6.0}, {true, true, true, true})};
  const auto united = LabelledUnion(around);
  ASSERT_EQ(united.size(), 1U);
  ASSERT_EQ(united[0].holes.size(), 1U);
  EXPECT_NEAR(planning::UnseenLength({united[0].holes[0], {}}), 2.0, 1e-3);  // above the lowest
  EXPECT_FALSE(Contains(united[0], {3.0, 3.0}));
  EXPECT_NEAR(UnseenLength(LabelledUnion(united)), UnseenLength(united), 1e-6);  // again: holes as input
}

// Two scans of a room with a door, each with a part of a wall that it has not found, and poses that err.
TEST(LabelledUnion, RegistrationNoiseDestroysNeitherWallsNorDoors) {
  const auto room = [](double gap) {
    return LabelledPolygon{{{{0.0, 0.0}, true},
                            {{1.0, 0.0}, false},
                            {{1.9, 0.0}, true},
                            {{5.0, 0.0}, true},
                            {{5.0, 4.0}, true},
                            {{gap + 1.0, 4.0}, false},
                            {{gap, 4.0}, true},
                            {{0.0, 4.0}, true}},
                           {}};
  };
  RandomStream stream = NamedStream(5, "test/labelled_union/noise");
  for (int round = 0; round < 200; ++round) {
    const auto noise = [&] {
      const Vector2d shift(DrawUniform(stream, -0.015, 0.015), DrawUniform(stream, -0.015, 0.015));
      const double angle = DrawUniform(stream, -0.5, 0.5) / 180.0 * kHalfCircle;
      const Vector2d center(2.5, 2.0);
      return slam::Pose2{0.0, center + shift} * slam::Pose2{angle, -center};
    };
    const auto united = LabelledUnion(std::vector{Moved(noise(), room(3.0)), Moved(noise(), room(1.0))});
    EXPECT_NEAR(UnseenLength(united), 0.9, 0.15) << round;
  }
}

TEST(LabelledUnion, MovesWithTheFrame) {
  RandomStream stream = NamedStream(4, "test/labelled_union/frame");
  const slam::Pose2 T_a_b{1.1, {30.0, -20.0}};
  for (int round = 0; round < 50; ++round) {
    const std::vector<LabelledPolygon> here{DrawStar(stream), DrawStar(stream), DrawRectangle(stream)};
    std::vector<LabelledPolygon> there;
    for (const LabelledPolygon& polygon : here) there.push_back(Moved(T_a_b, polygon));
    EXPECT_NEAR(SeenLength(LabelledUnion(here, kExact)), SeenLength(LabelledUnion(there, kExact)), 0.02);
  }
}

TEST(LabelledUnion, DamagedInputIsAnError) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error_of = [](LabelledPolygon polygon) {
    return ErrorOf([&] { LabelledUnion(std::vector{polygon}); });
  };
  EXPECT_THAT(error_of(Rectangle({0.0, nan}, {1.0, 1.0}, {})), HasSubstr("no place"));
  EXPECT_THAT(error_of(Rectangle({0.0, 0.0}, {1e6, 1.0}, {})), HasSubstr("no place"));
  EXPECT_THAT(error_of({{{{0.0, 0.0}, true}, {{1.0, 0.0}, true}}, {}}), HasSubstr("2 corners"));
  EXPECT_THAT(error_of({{}, {{{{0.0, 0.0}, true}}}}), HasSubstr("no outer ring"));
  EXPECT_THAT(
      error_of({{{{0.0, 0.0}, true}, {{1.0, 1.0}, true}, {{1.0, 0.0}, true}, {{0.0, 1.0}, true}}, {}}),
      HasSubstr("cross"));
  EXPECT_THAT(ErrorOf([&] { LabelledUnion({}, {-1.0, 0.0}); }), HasSubstr("tolerance"));
  EXPECT_TRUE(LabelledUnion({}).empty());
  EXPECT_TRUE(LabelledUnion(std::vector{LabelledPolygon{}}).empty());
}

}  // namespace
}  // namespace ariadne::planning
