// Fig. 1 and 8: the robot as a model, and the quantities of the control law.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/studies/robot_model.h"
#include "slam/geometry/box3.h"
#include "tests/experiments/studies/small_office.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::StartsWith;

slam::Box3 BoxOf(const slam::TriangleMesh& mesh) {
  slam::Box3 box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(p);
  return box;
}

TEST(RobotModel, IsAsLargeAsWhatCollides) {
  const drivers::SimulatedRobotOptions options;
  const slam::Box3 box = BoxOf(RobotMesh(options, 0.0));
  EXPECT_NEAR(box.min().x(), -0.4, 1e-9);
  EXPECT_NEAR(box.max().x(), 0.4, 1e-9);
  EXPECT_NEAR(box.min().y(), -0.3, 1e-9);
  EXPECT_NEAR(box.max().y(), 0.3, 1e-9);
  EXPECT_NEAR(box.min().z(), 0.0, 2e-3) << "wheels stand on the floor";
  EXPECT_NEAR(box.max().z(), 0.95 + 0.09, 1e-9) << "the scanner's top";
}

TEST(RobotModel, ItsScannerTiltsAboutItsOrigin) {
  const slam::Box3 level = BoxOf(ScannerMesh(0.0)), up = BoxOf(ScannerMesh(0.5));
  EXPECT_LE(level.sizes().x(), 0.24 + 1e-9);
  EXPECT_NEAR(level.sizes().y(), 0.35, 1e-9);
  EXPECT_NEAR(level.sizes().z(), 0.23, 0.01);
  EXPECT_NEAR(up.max().z(), 0.06 * std::sin(0.5) + 0.09 * std::cos(0.5), 1e-9) << "the front goes up";
  EXPECT_EQ(up.min().z(), level.min().z()) << "the mount stays";
}

class RobotFiguresTest : public StudyTest {};

TEST_F(RobotFiguresTest, Fig01DrawsTheSimulatedDimensions) {
  OptionEntries entries;
  entries.Set("width=160");
  entries.Set("robot.ais.mount_z=1.05");
  Run("fig_01", entries);
  EXPECT_EQ(ReadJson("run/metrics.json")["tilt_axis_m"], 1.05);
  EXPECT_THAT(Content("run/figures/fig_01.png"), StartsWith("\x89PNG"));
}

TEST_F(RobotFiguresTest, Fig08HasTheQuantitiesOfTheLaw) {
  OptionEntries entries;
  for (const char* assignment : {"width=200", "x=-2", "y=1.5", "heading=-70"}) entries.Set(assignment);
  Run("fig_08", entries);
  const Json metrics = ReadJson("run/metrics.json");
  const double e = metrics["e_m"], deg = std::numbers::pi / 180.0;
  const double theta = deg * metrics["theta_deg"].get<double>();
  const double alpha = deg * metrics["alpha_deg"].get<double>();
  EXPECT_NEAR(e, 2.5, 1e-12);
  EXPECT_NEAR(theta, std::atan2(-1.5, 2.0), 1e-12);
  EXPECT_NEAR(alpha, theta + 70.0 * deg, 1e-12);
  const double c = std::sin(alpha) / e + 2.0 * theta / e * std::sin(alpha) / alpha + 2.9 * alpha / e;
  EXPECT_NEAR(metrics["curvature_per_m"], c, 1e-9);
  EXPECT_NEAR(metrics["turning_rad_per_s"].get<double>(), c * metrics["forward_m_per_s"].get<double>(),
              1e-9);
  EXPECT_THAT(Content("run/figures/fig_08.png"), StartsWith("\x89PNG"));
}

TEST_F(RobotFiguresTest, Fig08NeedsADistanceToTheGoal) {
  OptionEntries entries;
  for (const char* assignment : {"x=0", "y=0.001"}) entries.Set(assignment);
  EXPECT_THAT(ErrorOf([&] { FindStudy("fig_08").check_input(entries); }),
              testing::HasSubstr("is the goal itself"));
}

}  // namespace
}  // namespace ariadne::experiments
