#include "drivers/simulated/obstacles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/drivers/simulated/box_room.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::drivers {
namespace {

using slam::Pose2;

double DepthAt(const World& world, double x, double y, double angle = 0.0) {
  return Obstacles(world, {}).ContactAt({angle, {x, y}}, 0.0).depth;
}

World WorldWith(const Body& body) {
  World world;
  world.name = "test";
  world.bodies.push_back(body);
  return world;
}

TEST(Obstacles, LeaveTheRobotAloneInAnEmptyWorld) { EXPECT_EQ(DepthAt(World{}, 1.0, 2.0), 0.0); }

TEST(Obstacles, DoNotCountTheFloorThatTheRobotStandsOn) {
  EXPECT_EQ(DepthAt(FurnishedRoom(), 0.0, 0.0), 0.0);
  EXPECT_EQ(DepthAt(FurnishedRoom(), 0.0, -2.69), 0.0) << "1 cm from the wall";
  EXPECT_NEAR(DepthAt(FurnishedRoom(), 0.0, -2.71), 0.01, 1e-12);
}

TEST(Obstacles, MatterOnlyAtTheRobotsHeights) {
  const auto depth = [](double bottom, double top) {
    return DepthAt(WorldWith(BoxBody("bar", {0.35, -2.0, bottom}, {0.5, 2.0, top})), 0.0, 0.0);
  };
  EXPECT_EQ(depth(0.0, 0.04), 0.0) << "a threshold";
  EXPECT_EQ(depth(1.2, 1.3), 0.0) << "a lamp";
  EXPECT_NEAR(depth(0.70, 0.74), 0.05, 1e-12) << "a table";
  EXPECT_NEAR(depth(0.0, 2.0), 0.05, 1e-12) << "a wall";
}

TEST(Obstacles, AreNamed) {
  const World room = FurnishedRoom();
  const Contact contact = Obstacles(room, {}).ContactAt({0.0, {1.6, 0.95}}, 0.0);
  EXPECT_NEAR(contact.depth, 0.05, 1e-12);
  EXPECT_EQ(room.bodies[contact.body].name, "pillar");
}

TEST(Obstacles, StandWhereTheirBodiesAre) {
  Body box = BoxBody("box", {-0.1, -0.1, 0.0}, {0.1, 0.1, 1.0});
  box.motion = {{0.0}, {slam::ToPose3({0.5, {3.0, 4.0}})}};
  EXPECT_EQ(DepthAt(WorldWith(box), 0.0, 0.0), 0.0);
  EXPECT_GT(DepthAt(WorldWith(box), 3.0, 4.0), 0.0);
}

TEST(Obstacles, MoveWithTheirBodies) {
  Body box = BoxBody("box", {-0.1, -0.1, 0.0}, {0.1, 0.1, 1.0});
  box.motion = {{0.0, 10.0}, {slam::ToPose3({0.0, {10.0, 0.0}}), slam::ToPose3({0.0, {0.0, 0.0}})}};
  const World world = WorldWith(box);
  const Obstacles obstacles(world, {});
  EXPECT_EQ(obstacles.ContactAt({}, 0.0).depth, 0.0);
  EXPECT_EQ(obstacles.ContactAt({}, 9.49).depth, 0.0);
  EXPECT_NEAR(obstacles.ContactAt({}, 9.6).depth, 0.1, 1e-9);
}

TEST(Obstacles, AreFoundInTheGridAsWithoutIt) {
  RandomStream stream = NamedStream(4, "obstacles_test/boxes");
  World world = EmptyRoom({-9.0, -7.0, 0.0}, {9.0, 7.0, 2.7});
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d low = slam::DrawInBox(stream, {-8.0, -6.0, 0.0}, {8.0, 6.0, 1.2});
    world.bodies.push_back(BoxBody("box", low, low + slam::DrawInBox(stream, {0, 0, 0}, {1.0, 1.0, 1.0})));
  }
  const Obstacles obstacles(world, {});
  int contacts = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Vector3d place = slam::DrawInBox(stream, {-9.0, -7.0, -3.0}, {9.0, 7.0, 3.0});
    const Pose2 pose{place.z(), place.head<2>()};
    double deepest = 0.0;
    for (const Body& body : world.bodies) {
      for (const auto& t : body.mesh_body.triangles) {
        const auto& v = body.mesh_body.vertices;
        deepest = std::max(deepest, OverlapDepth(OutlineBetween({v[t[0]], v[t[1]], v[t[2]]}, {0.05, 0.9}),
                                                 pose, {0.4, 0.3}));
      }
    }
    EXPECT_EQ(obstacles.ContactAt(pose, 0.0).depth, deepest);
    contacts += deepest > 0.0;
  }
  EXPECT_GT(contacts, 50);
}

TEST(Obstacles, RefuseAFlatRobot) {
  FootprintOptions footprint;
  footprint.lowest = footprint.highest;
  const World world;
  EXPECT_THAT(ErrorOf([&] { Obstacles(world, footprint); }), testing::HasSubstr("1 cm or more above"));
}

}  // namespace
}  // namespace ariadne::drivers
