#include "drivers/simulated/simulated_base.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/drivers/simulated/box_room.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using slam::Pose2;

SimulatedBaseOptions BaseWithoutErrors() {
  SimulatedBaseOptions options;
  options.wheels.radius_spread = options.wheels.track_spread = options.wheels.slip = 0.0;
  return options;
}

/// A wall of 10 cm across the way, whose near side is at x = 2.
World Wall() {
  World world;
  world.name = "wall";
  world.bodies.push_back(BoxBody("wall", {2.0, -3.0, 0.0}, {2.1, 3.0, 2.7}));
  return world;
}

/// A post that walks along the x axis from 5 m at 1 m/s to the origin.
World WalkingPost() {
  World world;
  Body post = BoxBody("post", {-0.2, -0.2, 0.0}, {0.2, 0.2, 1.8});
  post.motion = {{0.0, 5.0}, {slam::ToPose3({0.0, {5.0, 0.0}}), slam::Pose3{}}};
  world.bodies.push_back(post);
  return world;
}

/// Worlds outlive the robots in them.
const World kEmpty, kWall = Wall(), kWalkingPost = WalkingPost();

double ErrorOfTruth(const SimulatedBase& base, const Pose2& expected) {
  return (expected.Inverse() * base.T_map_base_true()).Log().norm();
}

void DriveFor(SimulatedBase& base, const Velocity& velocity, double duration) {
  base.Drive(velocity);
  base.WaitUntil(base.Now() + duration);
}

TEST(SimulatedBase, StandsAtTheStartOfTheWorld) {
  World world;
  world.T_map_start = {0.5, {3.0, 4.0}};
  SimulatedBase base(world, {}, 1);
  base.WaitUntil(100.0);
  EXPECT_EQ(base.Now(), 100.0);
  EXPECT_EQ(ErrorOfTruth(base, world.T_map_start), 0.0);
  EXPECT_EQ(base.path_true().size(), 1u);
  EXPECT_EQ(base.State().odometry.T_odom_base.translation.norm(), 0.0)
      << "it does not know where it starts";
}

TEST(SimulatedBase, DrivesACircle) {
  SimulatedBase base(kEmpty, BaseWithoutErrors(), 1);
  DriveFor(base, {0.4, 0.2}, 2.0 * std::numbers::pi / 0.2);  // radius 2 m
  base.Halt();
  const double late = 0.4 * 0.4 / 0.5;  // the speeds do not grow at the same time: not quite a circle
  EXPECT_LT(ErrorOfTruth(base, Pose2{}), late);
  for (const TruePose& pose : base.path_true()) {
    EXPECT_NEAR((pose.T_map_base.translation - Eigen::Vector2d(0.0, 2.0)).norm(), 2.0, late);
  }
}

TEST(SimulatedBase, HaltsWithinTheBrakingDistance) {
  SimulatedBase base(kEmpty, BaseWithoutErrors(), 1);
  DriveFor(base, {0.8, 0.0}, 5.0);
  const double before = base.T_map_base_true().translation.x();
  EXPECT_EQ(base.State().velocity.forward, 0.8);
  base.Halt();
  EXPECT_EQ(base.State().velocity.forward, 0.0);
  EXPECT_NEAR(base.T_map_base_true().translation.x() - before, 0.8 * 0.8 / (2.0 * 0.5), 1e-9);
}

TEST(SimulatedBase, MovesTheSameHoweverItIsWaitedFor) {
  SimulatedBase once(kEmpty, {}, 7), in_pieces(kEmpty, {}, 7);
  for (SimulatedBase* base : {&once, &in_pieces}) base->Drive({0.5, 0.3});
  once.WaitUntil(4.0);
  for (int i = 1; i <= 40; ++i) in_pieces.WaitUntil(0.1 * i);
  EXPECT_LT(ErrorOfTruth(once, in_pieces.T_map_base_true()), 1e-12) << "0.1 * i is rounded";
  EXPECT_EQ(once.path_true().size(), in_pieces.path_true().size());
}

TEST(SimulatedBase, RepeatsEveryBit) {
  SimulatedBase one(kWall, {}, 7), again(kWall, {}, 7), other(kWall, {}, 8);
  for (SimulatedBase* base : {&one, &again, &other}) DriveFor(*base, {0.5, 0.1}, 6.0);
  EXPECT_EQ(one.T_map_base_true().translation, again.T_map_base_true().translation);
  EXPECT_EQ(one.State().odometry.covariance, again.State().odometry.covariance);
  EXPECT_EQ(one.collisions().size(), again.collisions().size());
  EXPECT_NE(one.T_map_base_true().translation, other.T_map_base_true().translation);
}

TEST(SimulatedBase, IsStoppedByAWall) {
  SimulatedBase base(kWall, BaseWithoutErrors(), 1);
  DriveFor(base, {0.5, 0.0}, 10.0);
  EXPECT_NEAR(base.T_map_base_true().translation.x(), 1.6, 1e-5);
  EXPECT_LE(base.T_map_base_true().translation.x(), 1.6);
  EXPECT_EQ(base.collisions().size(), 1U);
  EXPECT_TRUE(base.State().blocked);
  EXPECT_EQ(base.State().velocity.forward, 0.0);
  EXPECT_NEAR(base.State().odometry.T_odom_base.translation.x(), 1.6, 2e-4) << "the wheels are blocked too";
}

TEST(SimulatedBase, CountsPushingOnOnceAndComingBackAgain) {
  SimulatedBase base(kWall, {}, 1);
  for (int push = 0; push < 50; ++push) DriveFor(base, {0.5, 0.0}, 0.5);
  EXPECT_EQ(base.collisions().size(), 1U);
  DriveFor(base, {-0.3, 0.0}, 2.0);
  EXPECT_FALSE(base.State().blocked) << "it drives away";
  EXPECT_LT(base.T_map_base_true().translation.x(), 1.4);
  DriveFor(base, {0.5, 0.0}, 5.0);
  EXPECT_EQ(base.collisions().size(), 2U);
}

TEST(SimulatedBase, CannotTurnItsCornersIntoAWall) {
  World world = Wall();
  world.T_map_start = {0.0, {1.59, 0.0}};
  SimulatedBase base(world, BaseWithoutErrors(), 1);
  DriveFor(base, {0.0, 0.5}, 3.0);
  EXPECT_EQ(base.collisions().size(), 1U);
  EXPECT_LT(base.T_map_base_true().angle, 0.1);
  EXPECT_NEAR(0.4 * std::cos(base.T_map_base_true().angle) + 0.3 * std::sin(base.T_map_base_true().angle),
              0.41, 1e-5);
}

TEST(SimulatedBase, FitsThroughADoorThatIsWideEnough) {
  for (const auto& [opening, crossed] : {std::pair(0.62, true), {0.58, false}}) {
    World world;
    world.bodies.push_back(BoxBody("left", {1.0, 0.5 * opening, 0.0}, {1.1, 3.0, 2.0}));
    world.bodies.push_back(BoxBody("right", {1.0, -3.0, 0.0}, {1.1, -0.5 * opening, 2.0}));
    world.bodies.push_back(BoxBody("lintel", {1.0, -3.0, 2.0}, {1.1, 3.0, 2.7}));
    SimulatedBase base(world, BaseWithoutErrors(), 1);
    DriveFor(base, {0.5, 0.0}, 8.0);
    EXPECT_EQ(base.collisions().empty(), crossed);
    EXPECT_EQ(base.T_map_base_true().translation.x() > 3.0, crossed);
  }
}

TEST(SimulatedBase, NeverEntersWhatStands) {
  const World room = FurnishedRoom();
  const Obstacles obstacles(room, {});
  std::size_t collisions = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SimulatedBase base(room, {}, seed);
    RandomStream stream = NamedStream(seed, "simulated_base_test/commands");
    for (int i = 0; i < 60; ++i) {
      DriveFor(base, {DrawUniform(stream, -0.8, 0.8), DrawUniform(stream, -1.0, 1.0)}, 1.0);
      EXPECT_EQ(obstacles.ContactAt(base.T_map_base_true(), base.Now()).depth, 0.0);
    }
    collisions += base.collisions().size();
  }
  EXPECT_GT(collisions, 10U);
}

TEST(SimulatedBase, GetsAwayFromWhatWalkedIntoIt) {
  SimulatedBase base(kWalkingPost, BaseWithoutErrors(), 1);
  base.WaitUntil(4.7);  // the post is at 0.3 m, 0.3 m deep in the robot
  EXPECT_EQ(base.collisions().size(), 0U) << "it stood";
  DriveFor(base, {0.3, 0.0}, 0.2);
  EXPECT_EQ(base.T_map_base_true().translation.x(), 0.0) << "no further in";
  EXPECT_EQ(base.collisions().size(), 1U);
  base.WaitUntil(5.5);
  DriveFor(base, {-0.5, 0.0}, 4.0);
  EXPECT_LT(base.T_map_base_true().translation.x(), -1.0);
  EXPECT_FALSE(base.State().blocked);
}

TEST(SimulatedBase, RefusesToStartInsideOfThings) {
  World world = Wall();
  world.T_map_start = {0.0, {1.7, 0.0}};
  EXPECT_THAT(ErrorOf([&] { SimulatedBase(world, {}, 1); }),
              testing::HasSubstr("inside of \"wall\"; move the start by 0.10 m"));
}

TEST(SimulatedBase, RefusesToWaitForever) {
  SimulatedBase base(kEmpty, {}, 1);
  const double forever = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ErrorOf([&] { base.WaitUntil(forever); }), testing::HasSubstr("cannot wait until inf s"));
  base.WaitUntil(-1.0);
  EXPECT_EQ(base.Now(), 0.0) << "that is over";
}

TEST(SimulatedBase, KnowsItsPast) {
  SimulatedBase base(kEmpty, BaseWithoutErrors(), 1);
  base.WaitUntil(1.0);
  DriveFor(base, {0.5, 0.0}, 4.0);
  const auto x_at = [](const Motion& way, double time) { return PoseAt(way, time).translation.x(); };
  EXPECT_EQ(x_at(base.WayBetween(0.2, 0.6), 0.5), 0.0);
  const Motion way = base.WayBetween(3.0, 3.025);
  EXPECT_LE(way.times.size(), 5u);
  EXPECT_NEAR(x_at(way, 3.02) - x_at(way, 3.0), 0.5 * 0.02, 1e-12);
  EXPECT_NEAR(x_at(base.WayBetween(4.99, 5.0), 5.0), base.T_map_base_true().translation.x(), 1e-15);
  const Motion start = base.WayBetween(0.5, 1.02);
  EXPECT_EQ(x_at(start, 1.0), 0.0) << "it stood until then";
  EXPECT_GT(x_at(start, 1.02), 0.0);
}

TEST(SimulatedBase, HasAnHonestOdometry) {
  constexpr int kSeeds = 250;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedBase base(kEmpty, {}, seed);
    DriveFor(base, {0.5, 0.3}, 4.0);
    DriveFor(base, {0.6, -0.4}, 3.0);
    DriveFor(base, {0.0, 0.8}, 2.0);
    DriveFor(base, {-0.3, 0.0}, 2.0);
    base.Halt();
    const slam::Odometry odometry = base.State().odometry;
    const Eigen::Vector3d error = (odometry.T_odom_base.Inverse() * base.T_map_base_true()).Log();
    sum += error.dot(odometry.covariance.ldlt().solve(error));
  }
  EXPECT_NEAR(sum, 3.0 * kSeeds, 3.0 * std::sqrt(6.0 * kSeeds)) << "chi-square, three sigma";
}

/// It accelerates until the command is stale, and brakes as long: twice a T^2 / 2, to the exact time.
TEST(SimulatedBase, BrakesByItselfWhenCommandsAreStale) {
  SimulatedBaseOptions options = BaseWithoutErrors();
  options.command_timeout = 0.2533;  // within a step
  const double way = options.wheels.acceleration * options.command_timeout * options.command_timeout;
  SimulatedBase base(kEmpty, options, 1), patient(kEmpty, options, 1);
  DriveFor(base, {0.8, 0.0}, 10.0);
  EXPECT_LT(ErrorOfTruth(base, {0.0, {way, 0.0}}), 1e-9);
  EXPECT_EQ(base.State().velocity.forward, 0.0);
  DriveFor(base, {0.8, 0.0}, 10.0);  // until the next command
  EXPECT_LT(ErrorOfTruth(base, {0.0, {2.0 * way, 0.0}}), 1e-9);

  patient.Drive({0.8, 0.0});
  for (int i = 1; i <= 1000; ++i) patient.WaitUntil(0.0017 * i);  // waiting is no command
  EXPECT_LT(ErrorOfTruth(patient, {0.0, {way, 0.0}}), 1e-9);
}

TEST(SimulatedBase, DoesNotNoticeItsTimeoutWhileCommandsCome) {
  SimulatedBaseOptions options;
  SimulatedBase free(kEmpty, options, 1);
  options.command_timeout = 0.25;
  SimulatedBase watched(kEmpty, options, 1);
  for (SimulatedBase* base : {&free, &watched}) {
    for (int i = 0; i < 60; ++i) DriveFor(*base, {0.5, 0.01 * i}, i % 2 == 0 ? 0.25 : 0.0531);
    base->Halt();
  }
  EXPECT_EQ(free.Now(), watched.Now());
  EXPECT_EQ(free.T_map_base_true().translation, watched.T_map_base_true().translation);
  EXPECT_EQ(free.T_map_base_true().angle, watched.T_map_base_true().angle);
}

}  // namespace
}  // namespace ariadne::drivers
