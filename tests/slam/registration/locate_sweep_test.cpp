#include "slam/registration/locate_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

constexpr double kHeight = 0.95;  // of the scanner [m]

/// A vertical wall as seen from the side to which `normal` points.
void AppendWall(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& normal,
                std::vector<Eigen::Vector3d>& points, std::vector<SurfacePoint>& surfaces) {
  const int count = static_cast<int>((to - from).norm() / 0.05);
  for (int i = 0; i <= count; ++i) {
    const Eigen::Vector2d p = from + (to - from) * i / count;
    for (const double z : {kHeight - 0.05, kHeight, kHeight + 0.05}) {
      points.emplace_back(p.x(), p.y(), z);
      surfaces.push_back({{normal.x(), normal.y(), 0.0}, false, 0.1});
    }
  }
}

/// The inside of a room of 6 m x 4 m, or only its two long walls.
AlignModel WallsOf(bool corridor) {
  std::vector<Eigen::Vector3d> points;
  std::vector<SurfacePoint> surfaces;
  AppendWall({0.0, 0.0}, {6.0, 0.0}, {0.0, 1.0}, points, surfaces);
  AppendWall({6.0, 4.0}, {0.0, 4.0}, {0.0, -1.0}, points, surfaces);
  if (!corridor) {
    AppendWall({6.0, 0.0}, {6.0, 4.0}, {-1.0, 0.0}, points, surfaces);
    AppendWall({0.0, 4.0}, {0.0, 0.0}, {1.0, 0.0}, points, surfaces);
  }
  return {KdTree(std::move(points)), std::move(surfaces)};
}

/// The model's points at the scanner's height, as a robot at a pose sees them.
std::vector<Eigen::Vector3d> SweepAt(const AlignModel& model, const Pose2& T_map_base) {
  std::vector<Eigen::Vector3d> points_base;
  for (const Eigen::Vector3d& p : model.tree.points()) {
    if (std::abs(p.z() - kHeight) > 0.01) continue;
    const Eigen::Vector2d p_base = T_map_base.Inverse() * Eigen::Vector2d(p.head<2>());
    points_base.emplace_back(p_base.x(), p_base.y(), kHeight);
  }
  return points_base;
}

Pose2::Square Sigmas(double position, double angle) {
  return Pose2::Tangent(position * position, position * position, angle * angle).asDiagonal();
}

TEST(LocateSweep, MendsTheGuess) {
  const AlignModel room = WallsOf(false);
  RandomStream stream = NamedStream(1, "locate_sweep_test");
  for (int i = 0; i < 50; ++i) {
    const Pose2 truth{DrawUniform(stream, -3.0, 3.0),
                      {DrawUniform(stream, 1.5, 4.5), DrawUniform(stream, 1.0, 3.0)}};
    const Pose2 guess = truth * Pose2::Exp({DrawUniform(stream, -0.1, 0.1), DrawUniform(stream, -0.1, 0.1),
                                            DrawUniform(stream, -0.03, 0.03)});
    const LocateResult located = LocateSweep(room, SweepAt(room, truth), guess, Sigmas(0.1, 0.05), {});
    ASSERT_TRUE(located.trusted);
    const Pose2 off = truth.Inverse() * located.T_map_base;
    EXPECT_LT(off.translation.norm(), 0.005) << i;
    EXPECT_LT(std::abs(off.angle), 0.002) << i;
    EXPECT_LT(located.covariance(0, 0), 0.01 * 0.01);
  }
}

TEST(LocateSweep, LeavesWhatNoWallHolds) {
  const AlignModel corridor = WallsOf(true);
  const Pose2 truth{0.0, {3.0, 1.5}};
  const Pose2 guess{0.0, {3.08, 1.58}};
  const LocateResult located =
      LocateSweep(corridor, SweepAt(corridor, truth), guess, Sigmas(0.1, 0.05), {});
  ASSERT_TRUE(located.trusted);
  EXPECT_NEAR(located.T_map_base.translation.y(), 1.5, 0.005);
  EXPECT_NEAR(located.T_map_base.translation.x(), 3.08, 0.01);
  EXPECT_NEAR(std::sqrt(located.covariance(0, 0)), 0.1, 0.02) << "as uncertain as before";
  EXPECT_LT(std::sqrt(located.covariance(1, 1)), 0.01);
}

TEST(LocateSweep, DoesNotTakeAThinWallForItsBack) {
  std::vector<Eigen::Vector3d> points;
  std::vector<SurfacePoint> surfaces;
  AppendWall({0.0, 0.0}, {6.0, 0.0}, {0.0, -1.0}, points, surfaces);  // seen from the room below
  const AlignModel back{KdTree(std::move(points)), std::move(surfaces)};
  const Pose2 truth{0.0, {3.0, 1.5}};
  const LocateResult located = LocateSweep(back, SweepAt(back, truth), truth, Sigmas(0.1, 0.05), {});
  EXPECT_FALSE(located.trusted);
  EXPECT_EQ(located.matched, 0.0);
}

TEST(LocateSweep, TrustsNothingElsewhere) {
  const AlignModel room = WallsOf(false);
  const Pose2 guess{0.3, {50.0, 50.0}};
  const LocateResult located =
      LocateSweep(room, SweepAt(room, {0.0, {3.0, 2.0}}), guess, Sigmas(0.1, 0.05), {});
  EXPECT_FALSE(located.trusted);
  EXPECT_EQ(located.T_map_base.translation, guess.translation);
  EXPECT_FALSE(LocateSweep(room, {}, guess, Sigmas(0.1, 0.05), {}).trusted);
}

}  // namespace
}  // namespace ariadne::slam
