// One step of planning on points of a room that are put where a scanner without errors would find them.
#include "experiments/studies/plan_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

constexpr double kMount = 0.5;  // of the laser above the floor [m]

/// A room of 6 x 4 m with an opening of 1 m ahead, as seen from the middle of its left half: walls from
/// 1.40 to 1.60 m above the floor, half a turn about x, and the floor.
slam::PosedCloud RoomScan(const slam::Pose3& T_map_laser = {}) {
  slam::PosedCloud scan;
  scan.name = "room";
  scan.T_map_laser = T_map_laser;
  for (double bearing = -90.0; bearing <= 90.0; bearing += 0.25) {
    const double angle = bearing * std::numbers::pi / 180.0;
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
    const double ahead = u.x() > 1e-9 ? 4.5 / u.x() : 1e9;
    const double aside = std::abs(u.y()) > 1e-9 ? 2.0 / std::abs(u.y()) : 1e9;
    const Eigen::Vector2d p = std::min(ahead, aside) * u;
    if (ahead < aside && std::abs(p.y()) < 0.5) continue;
    for (double z = 1.4; z < 1.605; z += 0.02)
      scan.cloud_laser.positions.emplace_back(p.x(), p.y(), z - kMount);
  }
  for (double x = 0.2; x < 4.4; x += 0.1) {
    for (double y = -1.9; y < 1.95; y += 0.1) scan.cloud_laser.positions.emplace_back(x, y, -kMount);
  }
  return scan;
}

slam::Pose3 LaserAt(double angle, double x, double y, double z) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())), {x, y, z}};
}

double AreaOf(const std::vector<planning::LabelledPolygon>& area) {
  double sum = 0.0;
  for (const planning::LabelledPolygon& polygon : area) sum += slam::Area(planning::ToPolygon2(polygon));
  return sum;
}

TEST(PlanStep, FindsTheFloorAtAnyHeight) {
  for (const double z : {0.0, 0.5, -7.25, 12.0}) {
    const std::vector scans{RoomScan(LaserAt(0.3, 1.0, 2.0, z))};
    EXPECT_NEAR(FloorUnder(scans), z - kMount, 0.02) << z;
  }
}

TEST(PlanStep, CutsAtAHeightAboveTheFloorOrOfTheMap) {
  const std::vector scans{RoomScan(LaserAt(0.0, 0.0, 0.0, 3.0))};
  PlanStepOptions options;
  EXPECT_NEAR(PlanNextScan(scans, options).slice_z, 4.0, 0.02);
  options.from_floor = false;
  options.height = 4.05;
  EXPECT_EQ(PlanNextScan(scans, options).slice_z, 4.05);
}

TEST(PlanStep, KnowsTheRoomAndLooksForTheOpening) {
  const std::vector scans{RoomScan()};
  const PlanStep step = PlanNextScan(scans, {});
  ASSERT_EQ(step.polygons.size(), 1U);
  EXPECT_NEAR(AreaOf(step.polygons), 4.5 * 4.0, 0.2);
  EXPECT_NEAR(planning::SeenLength(step.polygons[0]), 2 * 4.5 + 3.0, 0.3);
  EXPECT_NEAR(planning::UnseenLength(step.polygons[0]), 1.0 + 4.0, 0.3)
      << "opening, and behind the scanner";
  EXPECT_GT(AreaOf(step.area), AreaOf(step.polygons)) << "and where the robot stands";
  ASSERT_TRUE(step.plan.chosen);
  EXPECT_GT(step.plan.views[*step.plan.chosen].gain, 5);
}

TEST(PlanStep, IsTheSameInAnyFrame) {
  const std::vector here{RoomScan()}, there{RoomScan(LaserAt(2.0, -30.0, 12.0, 5.0))};
  const PlanStep a = PlanNextScan(here, {}), b = PlanNextScan(there, {});
  EXPECT_NEAR(AreaOf(a.area), AreaOf(b.area), 0.1);
  EXPECT_NEAR(b.T_map_robot.angle, 2.0, 1e-9);
  EXPECT_NEAR((b.T_map_robot.translation - Eigen::Vector2d(-30.0, 12.0)).norm(), 0.0, 1e-9);
}

TEST(PlanStep, UnitesScansWhereTheyStand) {
  // The second turns about in the same place: together they see the hall from both ends of its middle.
  const std::vector scans{RoomScan(), RoomScan(LaserAt(std::numbers::pi, 0.0, 0.0, 0.0))};
  const PlanStep step = PlanNextScan(scans, {});
  EXPECT_NEAR(AreaOf(step.area), 2.0 * 4.5 * 4.0, 0.4);
  EXPECT_NEAR(step.T_map_robot.translation.norm(), 0.0, 1e-9);
}

TEST(PlanStep, SaysWhatIsMissing) {
  EXPECT_THAT(ErrorOf([] { PlanNextScan({}, {}); }), testing::HasSubstr("no scans"));
  const std::vector scans{RoomScan()};
  PlanStepOptions options;
  options.height = 2.5;
  EXPECT_THAT(ErrorOf([&] { PlanNextScan(scans, options); }),
              testing::HasSubstr("nothing at the height of 2.5"));
  std::vector floating{RoomScan()};
  std::erase_if(floating[0].cloud_laser.positions, [](const Eigen::Vector3d& p) { return p.z() < 0.0; });
  EXPECT_THAT(ErrorOf([&] { PlanNextScan(floating, {}); }), testing::HasSubstr("show no floor"));
}

}  // namespace
}  // namespace ariadne::experiments
