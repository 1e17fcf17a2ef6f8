#include "drivers/simulated/world_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/simulated/load_world.h"
#include "drivers/simulated/obstacles.h"
#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/solids.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

World Parse(const std::string& things) {
  return ParseWorld("start: [1, 2, 90]\nthings:\n" + things, "test.yaml");
}

std::string ErrorOfWorld(const std::string& text) {
  return ErrorOf([&] { ParseWorld(text, "test.yaml"); });
}

std::string ErrorOfThings(const std::string& things) {
  return ErrorOfWorld("start: [0, 0, 0]\nthings:\n" + things);
}

slam::Box3 BoxOf(const Body& body) { return slam::BoxAround(body.mesh_body.vertices); }

TEST(ParseWorld, ReadsStartAndThings) {
  const World world =
      Parse("  - box: {at: [3, 4], turn: 90, length: 2, depth: 1, height: 0.5, name: bench}\n");
  EXPECT_NEAR(world.T_map_start.angle, std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(world.T_map_start.translation, Eigen::Vector2d(1, 2));
  ASSERT_EQ(world.bodies.size(), 1u);
  EXPECT_EQ(world.bodies[0].name, "bench/wood");
  EXPECT_TRUE(
      BoxOf(world.bodies[0]).isApprox(slam::Box3(Vector3d(2, 3.5, 0), Vector3d(4, 4.5, 0.5)), 1e-12));
}

TEST(ParseWorld, PlacesGroupsInGroups) {
  const World world = ParseWorld(
      "start: [0, 0, 0]\n"
      "groups:\n"
      "  one: [{box: {at: [1, 0], length: 0.2, depth: 0.2, height: 1}}]\n"
      "  two: [{group: {of: one, at: [1, 0], turn: 90}}, {group: {of: one, at: [0, 0]}}]\n"
      "things: [{group: {of: two, at: [10, 0], turn: 90}}]\n",
      "test.yaml");
  ASSERT_EQ(world.bodies.size(), 2u);
  EXPECT_TRUE(BoxOf(world.bodies[0]).center().isApprox(Vector3d(9, 1, 0.5), 1e-12));
  EXPECT_TRUE(BoxOf(world.bodies[1]).center().isApprox(Vector3d(10, 1, 0.5), 1e-12));
}

TEST(ParseWorld, GivesMaterialsTheirReflectance) {
  const World world = ParseWorld(
      "start: [0, 0, 0]\nmaterials: {mirror: 0.02, wood: 0.4}\nthings:\n"
      "  - box: {at: [0, 0], material: mirror}\n  - box: {at: [3, 0]}\n",
      "test.yaml");
  EXPECT_EQ(world.bodies[0].material.reflectance, 0.02);
  EXPECT_EQ(world.bodies[1].material.reflectance, 0.4);
}

TEST(ParseWorld, LetsBodiesMove) {
  const World world = Parse("  - person: {path: [[0, 1, 0, 0], [2, 3, 0, 90]], stride: 0.6}\n");
  ASSERT_GT(world.bodies.size(), 3u);
  for (const Body& body : world.bodies) {
    EXPECT_TRUE(body.motion.moves());
    EXPECT_TRUE(PoseAt(body.motion, 1.0).translation.isApprox(Vector3d(2, 0, 0)));
    EXPECT_LT(BoxOf(body).center().head<2>().norm(), 0.3) << "the mesh is in the body's frame";
  }
}

TEST(ParseWorld, CutsOpeningsIntoWalls) {
  const RayScene scene(
      Parse("  - wall: {from: [0, 5], to: [10, 5], thickness: 0.2, height: 3, openings:\n"
            "      [{at: 2, width: 1, top: 2}, {at: 6, width: 2, bottom: 1, top: 2}]}\n"));
  const auto distance = [&](double x, double z) {
    return scene.Cast({Vector3d(x, 0, z), Vector3d::UnitY()}).distance;
  };
  const double through = Hit().distance;
  EXPECT_EQ(distance(1.4, 1.0), 4.9);
  EXPECT_EQ(distance(1.6, 1.0), through);
  EXPECT_EQ(distance(2.0, 2.1), 4.9) << "the lintel";
  EXPECT_EQ(distance(6.0, 0.9), 4.9) << "the sill";
  EXPECT_EQ(distance(6.0, 1.1), through);
  EXPECT_EQ(distance(10.1, 1.0), through);
}

TEST(ParseWorld, HangsDoorsByTheirHinges) {
  const auto leaf = [](const std::string& keys) {
    const World world =
        Parse("  - wall: {from: [0, 0], to: [4, 0], thickness: 0.1, openings: [{at: 2, width: 1, " + keys +
              "}]}\n");
    const auto door = std::ranges::find(world.bodies, "wall 1/door", &Body::name);
    return door == world.bodies.end() ? slam::Box3() : BoxOf(*door);
  };
  EXPECT_TRUE(leaf("").isEmpty());
  const slam::Box3 closed = leaf("hinge: start");
  EXPECT_NEAR(closed.min().x(), 1.505, 1e-9);
  EXPECT_NEAR(closed.max().x(), 2.495, 1e-9);
  EXPECT_LE(closed.max().y(), 0.05 + 1e-9) << "inside of the wall";
  EXPECT_NEAR(leaf("hinge: start, angle: 90").max().y(), 1.04, 1e-9) << "to the left";
  EXPECT_NEAR(leaf("hinge: start, angle: 90").max().x(), 1.545, 1e-9);
  EXPECT_NEAR(leaf("hinge: end, angle: 90").min().x(), 2.455, 1e-9);
  EXPECT_NEAR(leaf("hinge: end, angle: -90").min().y(), -1.04, 1e-9) << "to the right";
}

TEST(ParseWorld, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_THAT(ErrorOfWorld("things: []\n"), HasSubstr("test.yaml:1: the key start is missing"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0]\n"), HasSubstr("test.yaml:1: start needs a list of 3 numbers"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, x]\n"), HasSubstr("start needs a number, not x"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, .nan]\n"), HasSubstr("start needs a number"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, 0]\nthing: []\n"),
              HasSubstr("test.yaml:2: unknown key thing; did you mean things?"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, 0]\nstart: [0, 0, 0]\n"),
              HasSubstr("test.yaml:2: the key start is repeated"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, 0\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(ErrorOfWorld("- 1\n"), HasSubstr("a world is a map"));
  EXPECT_THAT(ErrorOfWorld(""), HasSubstr("one YAML document, not 0"));
  EXPECT_THAT(ErrorOfWorld("start: [0, 0, 0]\nmaterials: {wood: 1.5}\n"),
              HasSubstr("test.yaml:2: wood is 1.5, but must be in 0 to 1"));
  EXPECT_THAT(ErrorOfThings("  - tabel: {at: [0, 0]}\n"),
              HasSubstr("test.yaml:3: unknown kind tabel; did you mean table?"));
  EXPECT_THAT(ErrorOfThings("  - table: {at: [0, 0], heigth: 1}\n"),
              HasSubstr("test.yaml:3: unknown key heigth; did you mean height?"));
  EXPECT_THAT(ErrorOfThings("  - table: {at: [0, 0], height: 9}\n"),
              HasSubstr("test.yaml:3: height is 9, but must be in 0.1 to 3"));
  EXPECT_THAT(ErrorOfThings("  - shelf: {at: [0, 0], boards: 2.5}\n"),
              HasSubstr("boards needs a whole number"));
  EXPECT_THAT(ErrorOfThings("  - table: {at: [0, 0], material: wodo}\n"),
              HasSubstr("unknown material wodo; did you mean wood?"));
  EXPECT_THAT(ErrorOfThings("  - table:\n"), HasSubstr("table is a map of keys"));
  EXPECT_THAT(ErrorOfThings("  - table: {}\n"), HasSubstr("the key at is missing"));
  EXPECT_THAT(ErrorOfThings("  - {table: {at: [0, 0]}, chair: {at: [1, 1]}}\n"),
              HasSubstr("one kind with its keys"));
  EXPECT_THAT(ErrorOfThings("  - wall: {from: [0, 0], to: [0, 0]}\n"), HasSubstr("ends where it begins"));
  EXPECT_THAT(ErrorOfThings("  - wall: {from: [0, 0], to: [3, 0], openings: [{at: 1}, {at: 1.5}]}\n"),
              HasSubstr("test.yaml:3: the opening at 1.5 m overlaps"));
  EXPECT_THAT(ErrorOfThings("  - wall: {from: [0, 0], to: [3, 0], openings: [{at: 2.9}]}\n"),
              HasSubstr("beyond the wall's end"));
  EXPECT_THAT(ErrorOfThings("  - wall: {from: [0, 0], to: [3, 0], openings: [{at: 1, hinge: left}]}\n"),
              HasSubstr("hinge is one of none, start, end, not left"));
  EXPECT_THAT(ErrorOfThings("  - floor: {corners: [[0, 0], [2, 2], [2, 0], [0.5, 2]]}\n"),
              HasSubstr("test.yaml:3: the outline of 4 corners crosses itself"));
  EXPECT_THAT(ErrorOfThings("  - person: {path: [[0, 0, 0, 0], [0, 1, 0, 0]]}\n"),
              HasSubstr("must ascend"));
  EXPECT_THAT(ErrorOfThings("  - group: {of: x, at: [0, 0]}\n"), HasSubstr("unknown group x"));
  EXPECT_THAT(
      ErrorOfWorld("start: [0, 0, 0]\ngroups: {g: [{group: {of: g, at: [0, 0]}}]}\nthings: [{group: "
                   "{of: g, at: [0, 0]}}]\n"),
      HasSubstr("nested too deeply, or in itself"));
}

TEST(ParseWorld, SurvivesDamagedFiles) {
  const BuiltinWorld& hall = BuiltinWorlds()[0];
  RandomStream stream = NamedStream(5, "damage");
  const std::string_view bytes = "{}[]:,-&*!|>'\"#%@ \n\t0a\xff";
  for (int round = 0; round < 150; ++round) {
    std::string text(hall.yaml.substr(0, 2500 + stream() % 1500));
    for (int i = 0; i < 3; ++i) text[stream() % text.size()] = bytes[stream() % bytes.size()];
    try {
      ParseWorld(text, "damaged.yaml");
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("damaged.yaml"));
    }
  }
}

TEST(ReadWorldFile, SaysWhatCannotBeRead) {
  EXPECT_THROW(ReadWorldFile("/nowhere/world.yaml"), Error);
  EXPECT_THROW(ReadWorldFile("/tmp"), Error);
}

class Builtin : public testing::TestWithParam<std::string> {};

TEST_P(Builtin, IsMadeOfClosedBodies) {
  const World world = LoadWorld("builtin:" + GetParam());
  EXPECT_EQ(world.name, GetParam());
  EXPECT_GT(world.bodies.size(), 50u);
  for (const Body& body : world.bodies) {
    EXPECT_TRUE(IsClosed(body.mesh_body)) << body.name;
    EXPECT_GT(Volume(body.mesh_body), 0.0) << body.name;
    EXPECT_GT(body.material.reflectance, 0.0) << body.name;
  }
}

TEST_P(Builtin, LetsTheRobotStart) {
  const World world = LoadWorld("builtin:" + GetParam());
  EXPECT_EQ(Obstacles(world, {}).ContactAt(world.T_map_start, 0.0).depth, 0.0);
}

TEST_P(Builtin, HasFloorAndCeilingAtTheStart) {
  const RayScene scene(LoadWorld("builtin:" + GetParam()));
  const Eigen::Vector2d start = scene.world().T_map_start.translation;
  EXPECT_NEAR(scene.Cast({Vector3d(start.x(), start.y(), 1.0), -Vector3d::UnitZ()}).distance, 1.0, 1e-9);
  EXPECT_LT(scene.Cast({Vector3d(start.x(), start.y(), 1.0), Vector3d::UnitZ()}).distance, 7.0);
}

INSTANTIATE_TEST_SUITE_P(Worlds, Builtin, testing::Values("robobench", "entrance_hall"),
                         [](const auto& world) { return world.param; });

TEST(Robobench, LetsTheRobotDownTheCorridor) {
  const World world = LoadWorld("builtin:robobench");
  const Obstacles obstacles(world, {});
  for (double x = 1.0; x <= 35.0; x += 0.05) {
    const Contact contact = obstacles.ContactAt({0.0, {x, 0.0}}, 0.0);
    EXPECT_EQ(contact.depth, 0.0) << "x = " << x << ": " << world.bodies[contact.body].name;
  }
}

TEST(LoadWorld, SaysWhatThereIs) {
  const auto error = [](const std::string& source) -> std::string {
    try {
      LoadWorld(source);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error("builtin:robbench"), HasSubstr("there are entrance_hall, robobench"));
  EXPECT_THAT(error("plan.txt"), HasSubstr("expected builtin:NAME"));
  EXPECT_THAT(error("/nowhere/x.json"), HasSubstr("cannot open the floor plan"));
  EXPECT_THAT(error("/nowhere/x.dae"), HasSubstr("cannot open the mesh"));
}

}  // namespace
}  // namespace ariadne::drivers
