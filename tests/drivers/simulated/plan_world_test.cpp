#include "drivers/simulated/plan_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/simulated/floor_plan.h"
#include "drivers/simulated/obstacles.h"
#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/solids.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

/// Two rooms of 4 x 3 m side by side; the wall between them is drawn twice, with a door of 0.9 m at
/// (4, 1.5).
constexpr const char* kTwoRooms = R"({"name": "two rooms", "unit": "m", "start": [1, 1],
  "walls": [[0, 0, 4, 0], [4, 0, 4, 1.05], [4, 1.95, 4, 3], [4, 3, 0, 3], [0, 3, 0, 0],
            [4, 0, 8, 0], [8, 0, 8, 3], [8, 3, 4, 3], [4, 3, 4, 1.95], [4, 1.05, 4, 0]],
  "doors": [[4, 1.5]],
  "spaces": [{"label": "office", "polygon": [[0, 0], [4, 0], [4, 3], [0, 3]]},
             {"label": "office", "polygon": [[4, 0], [8, 0], [8, 3], [4, 3]]}]})";

std::string ErrorOfPlan(const std::string& text, const PlanOptions& options = {}) {
  return ErrorOf([&] { ParsePlan(text, "plan.json", options); });
}

TEST(MergeWalls, DropsRepetitionsAndJoinsPieces) {
  EXPECT_EQ(MergeWalls(ParseFloorPlan(kTwoRooms, "").walls).size(), 6u);
  const auto merged = MergeWalls(
      {{{0, 0}, {1, 0}}, {{3, 0}, {2, 0}}, {{0.9, 0}, {2.1, 0}}, {{5, 0}, {6, 0}}, {{7, 7}, {7, 7}}});
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_NEAR(merged[0].length(), 3.0, 1e-12);
}

TEST(FindDoorways, FindsGapsAtDoorsOnly) {
  const FloorPlan plan = ParseFloorPlan(kTwoRooms, "");
  const std::vector<PlanWall> doorways = FindDoorways(MergeWalls(plan.walls), plan.doors);
  ASSERT_EQ(doorways.size(), 1u);
  EXPECT_NEAR(doorways[0].length(), 0.9, 1e-12);
  EXPECT_TRUE(FindDoorways(MergeWalls(plan.walls), {}).empty());
}

TEST(ParsePlan, MakesWallsOfTheirThicknessWithDoors) {
  PlanOptions options;
  options.thickness = 0.2;
  const RayScene scene(ParsePlan(kTwoRooms, "plan.json", options));
  const auto distance = [&](double y, double z) {
    return scene.Cast({Vector3d(1, y, z), Vector3d::UnitX()}).distance;
  };
  EXPECT_NEAR(distance(0.5, 1.0), 2.9, 1e-9);
  EXPECT_NEAR(distance(1.5, 1.0), 6.9, 1e-9) << "through the door";
  EXPECT_NEAR(distance(1.5, 2.2), 2.9, 1e-9) << "the lintel";
  EXPECT_NEAR(distance(1.09, 1.0), 6.9, 1e-9) << "past the frame, which takes 3 cm";
  EXPECT_NEAR(distance(1.07, 1.0), 2.885, 1e-9) << "the frame stands out 1.5 cm";
  EXPECT_NEAR(scene.Cast({Vector3d(1, 1, 1), -Vector3d::UnitZ()}).distance, 1.0, 1e-9);
  EXPECT_NEAR(scene.Cast({Vector3d(1, 1, 1), Vector3d::UnitZ()}).distance, 1.7, 1e-9);
  EXPECT_TRUE(scene.Cast({Vector3d(-0.5, -0.05, 1), Vector3d::UnitX()}).hit()) << "corners are full";
}

TEST(ParsePlan, KeepsTheRobotInTheWorld) {
  // With the second room gone from the spaces, its door leads outside and is closed.
  std::string text = kTwoRooms;
  text.resize(text.rfind(",\n"));
  const RayScene closed(ParsePlan(text + "]}", "plan.json"));
  EXPECT_LT(closed.Cast({Vector3d(1, 1.5, 1), Vector3d::UnitX()}).distance, 3.0);
  const RayScene yard(ParsePlan(kTwoRooms, "plan.json"));
  EXPECT_NEAR(yard.Cast({Vector3d(-0.5, 1.5, 1), -Vector3d::UnitX()}).distance, 0.4, 1e-9)
      << "a wall around all";
}

TEST(ParsePlan, NarrowsDoorsIfAsked) {
  PlanOptions options;
  options.door_width = 0.7;
  const RayScene scene(ParsePlan(kTwoRooms, "plan.json", options));
  EXPECT_GT(scene.Cast({Vector3d(1, 1.5, 1), Vector3d::UnitX()}).distance, 6.0);
  EXPECT_LT(scene.Cast({Vector3d(1, 1.1, 1), Vector3d::UnitX()}).distance, 3.0);
}

TEST(ParsePlan, FurnishesBySeed) {
  PlanOptions options;
  options.furniture = 0.4;
  const World bare = ParsePlan(kTwoRooms, "plan.json"), one = ParsePlan(kTwoRooms, "plan.json", options);
  EXPECT_GT(one.bodies.size(), bare.bodies.size());
  const World again = ParsePlan(kTwoRooms, "plan.json", options);
  ASSERT_EQ(one.bodies.size(), again.bodies.size());
  for (std::size_t i = 0; i < one.bodies.size(); ++i) {
    EXPECT_EQ(one.bodies[i].mesh_body.vertices, again.bodies[i].mesh_body.vertices);
    EXPECT_TRUE(IsClosed(one.bodies[i].mesh_body)) << one.bodies[i].name;
  }
  const Obstacles obstacles(one, {});
  for (double x = 3.4; x < 4.6; x += 0.1)
    EXPECT_EQ(obstacles.ContactAt({0.0, {x, 1.5}}, 0.0).depth, 0.0) << x;
}

TEST(ParsePlan, NamesFileAndPlaceOfWhatIsWrong) {
  EXPECT_THAT(ErrorOfPlan("{\n \"start\": [1, 2],,}"), HasSubstr("plan.json:2:18: not valid JSON"));
  EXPECT_THAT(ErrorOfPlan(""), HasSubstr("plan.json:1:1: not valid JSON"));
  EXPECT_THAT(ErrorOfPlan("[]"), HasSubstr("a floor plan is a JSON object"));
  EXPECT_THAT(ErrorOfPlan("{\"walls\": []}"), HasSubstr("the key \"start\" is missing"));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 0], "walls": []})"), HasSubstr("has no walls"));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 0], "walls": {}})"),
              HasSubstr("\"walls\" must be array, not object"));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 0], "walls": [[0, 0, 1, 0], [0, 0, 1]]})"),
              HasSubstr("walls[1] needs 4 numbers"));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 0], "walls": [[0, 0, 1, "a"]]})"),
              HasSubstr("walls[0] needs 4 numbers, but one is string"));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 1e300], "walls": [[0, 0, 1, 0]]})"),
              HasSubstr("start is 1e+300 m away"));
  EXPECT_THAT(ErrorOfPlan(R"({"unit": "ft", "start": [0, 0], "walls": []})"),
              HasSubstr("unit of a floor plan is \"m\", not \"ft\""));
  EXPECT_THAT(ErrorOfPlan(R"({"start": [0, 0], "walls": [[0, 0, 1, 0]], "spaces": [{}]})"),
              HasSubstr("spaces[0] needs a polygon"));
  PlanOptions options;
  options.thickness = -1.0;
  EXPECT_THAT(ErrorOfPlan(kTwoRooms, options), HasSubstr("plan.thickness is -1 m"));
}

TEST(ParsePlan, SurvivesDamagedFiles) {
  RandomStream stream = NamedStream(6, "damage");
  const std::string_view bytes = "{}[]:,-\"0e.9 \n\xff";
  PlanOptions options;
  options.furniture = 0.5;
  for (int round = 0; round < 300; ++round) {
    std::string text = kTwoRooms;
    for (int i = 0; i < 2; ++i) text[stream() % text.size()] = bytes[stream() % bytes.size()];
    if (round % 3 == 0) text.resize(stream() % text.size());
    try {
      ParsePlan(text, "damaged.json", options);
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("damaged.json"));
    }
  }
}

TEST(ReadPlanWorld, ReadsAllPlansOfTheDataSet) {
  const char* data = std::getenv("ARIADNE_DATA");
  if (data == nullptr || !std::filesystem::exists(std::string(data) + "/plans")) {
    GTEST_SKIP() << "needs the floor plans: ARIADNE_DATA is not set to a folder with plans/";
  }
  PlanOptions options;
  options.furniture = 0.1;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(data) + "/plans")) {
    if (entry.path().extension() != ".json") continue;
    const RayScene scene(ReadPlanWorld(entry.path().string(), options));
    const Vector2d start = scene.world().T_map_start.translation;
    const Obstacles obstacles(scene.world(), {});
    EXPECT_EQ(obstacles.ContactAt(scene.world().T_map_start, 0.0).depth, 0.0) << entry.path();
    const Ray up{Vector3d(start.x(), start.y(), 1.0), Vector3d::UnitZ()};
    EXPECT_NEAR(scene.Cast(up).distance, 1.7, 1e-9) << entry.path();
  }
}

}  // namespace
}  // namespace ariadne::drivers
