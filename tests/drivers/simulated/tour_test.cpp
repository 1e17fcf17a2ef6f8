#include "drivers/simulated/tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "slam/geometry/angles.h"
#include "tests/drivers/simulated/box_room.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

const Tour kCorner{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}}, 1.0, 100};

World RoomFor(const Tour& tour) {
  World world = EmptyRoom({-2.0, -2.0, 0.0}, {6.0, 6.0, 2.7});
  world.T_map_start = StartOf(tour);
  return world;
}

TEST(ParseWaypoints, ReadsPoints) {
  EXPECT_THAT(ParseWaypoints("0 1, 2.5 -3", "w"),
              testing::ElementsAre(Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(2.5, -3.0)));
}

TEST(ParseWaypoints, SaysWhatIsNoPoint) {
  for (const char* text : {"0 1, 2", "0 1, 2 3 4", "0 1, a b", "0 1,, 2 3"}) {
    EXPECT_THAT(ErrorOf([&] { ParseWaypoints(text, "waypoints"); }), HasSubstr("waypoints: '")) << text;
  }
  EXPECT_THAT(ErrorOf([] { ParseWaypoints("0 1", "waypoints"); }), HasSubstr("two points"));
}

TEST(StopsOf, GoesOnAroundCorners) {
  const Tour tour{{{0.0, 0.0}, {2.5, 0.0}, {2.5, 2.0}}, 1.0, 100};
  const std::vector<Eigen::Vector2d> stops = StopsOf(tour);
  ASSERT_EQ(stops.size(), 5U);
  EXPECT_LT((stops[2] - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((stops[3] - Eigen::Vector2d(2.5, 0.5)).norm(), 1e-12);
  EXPECT_LT((stops[4] - Eigen::Vector2d(2.5, 1.5)).norm(), 1e-12);
}

TEST(StopsOf, EndsWhenThereAreEnough) {
  EXPECT_EQ(StopsOf({kCorner.waypoints_map, 1.0, 3}).size(), 3U);
  EXPECT_EQ(StopsOf(kCorner).size(), 6U);
}

TEST(DriveTour, StopsWhereItShouldAndLooksAhead) {
  const World world = RoomFor(kCorner);
  SimulatedBase base(world, {}, 1);
  const std::vector<TourStop> stops = DriveTour(base, kCorner, 3.4);
  const std::vector<Eigen::Vector2d> goals = StopsOf(kCorner);
  ASSERT_EQ(stops.size(), goals.size());
  for (std::size_t i = 0; i < stops.size(); ++i) {
    EXPECT_LT((stops[i].T_map_base_true.translation - goals[i]).norm(), 0.03) << i;
    const double heading = i <= 3 ? 0.0 : std::numbers::pi / 2.0;
    EXPECT_NEAR(slam::WrapAngle(stops[i].T_map_base_true.angle - heading), 0.0, 0.05) << i;
    if (i == 0) continue;
    EXPECT_GT(stops[i].time, stops[i - 1].time + 3.4) << "each stop lasts as long as a scan";
  }
}

TEST(DriveTour, HasNoErrorOfOdometryWithoutErrorsOfTheWheels) {
  const World world = RoomFor(kCorner);
  SimulatedBaseOptions options;
  options.wheels.radius_spread = options.wheels.track_spread = options.wheels.slip = 0.0;
  SimulatedBase base(world, options, 1);
  const std::vector<TourStop> stops = DriveTour(base, kCorner, 3.4);
  for (const TourStop& stop : stops) {
    const slam::Pose2 difference = stop.odometry.T_odom_base.Inverse() * stop.T_map_base_true;
    EXPECT_LT(difference.translation.norm(), 2e-3) << "the quantization of the ticks is left";
  }
}

TEST(DriveTour, SaysWhereTheWorldIsInTheWay) {
  World world = RoomFor(kCorner);
  world.bodies.push_back(BoxBody("wall", {1.5, -2.0, 0.0}, {1.6, 6.0, 2.7}));
  SimulatedBase base(world, {}, 1);
  EXPECT_THAT(ErrorOf([&] { DriveTour(base, kCorner, 3.4); }), HasSubstr("the tour is blocked at (1.1"));
}

}  // namespace
}  // namespace ariadne::drivers
