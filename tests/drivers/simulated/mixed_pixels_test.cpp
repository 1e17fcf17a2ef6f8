#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/simulated/ais_scanner.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {
namespace {

constexpr double kDepth = 0.25;        // from the pillar to the wall behind it: within a pulse [m]
constexpr double kHalfWidth = 0.1834;  // of the pillar: beams 3 deg aside hit its edges [m]

/// A wall 4 m ahead of the base, and before it, at its middle, a pillar.
World WallWithPillar() {
  World world = EmptyRoom({-4, -4, 0}, {4, 4, 3});
  world.bodies.push_back(BoxBody("pillar", {4.0 - kDepth, -kHalfWidth, 0.0}, {4.0, kHalfWidth, 3.0}));
  return world;
}

AisScannerOptions OnlyMixedPixels() {
  AisScannerOptions options;
  options.range_finder = WithoutErrors(options.range_finder);
  options.range_finder.mixed_pixels = true;
  return options;
}

slam::Scan TakeAtStart(const World& world, const AisScannerOptions& options) {
  return TakeAisScan(RayScene(world), {}, 0.0, options, 1, 0, Parallel(2));
}

/// How far the rays of the beam's cone are apart in range: large at edges, small on surfaces.
double SpreadOf(const RayScene& scene, const Ray& beam, double divergence) {
  double nearest = 1e9, farthest = 0.0;
  const Eigen::Vector3d across = beam.direction_map.unitOrthogonal();
  const Eigen::Vector3d other = beam.direction_map.cross(across);
  for (int i = 0; i <= 64; ++i) {
    const double radius = i == 64 ? 0.0 : 0.5 * divergence;
    const Eigen::Vector3d offset = radius * (std::cos(0.1 * i) * across + std::sin(0.1 * i) * other);
    const double r =
        scene.Cast({beam.origin_map, (beam.direction_map + offset).normalized(), beam.time}).distance;
    nearest = std::min(nearest, r);
    farthest = std::max(farthest, r);
  }
  return farthest - nearest;
}

TEST(MixedPixels, AppearOnlyAtEdges) {
  const AisScannerOptions options = OnlyMixedPixels();
  AisScannerOptions exact = options;
  exact.range_finder.mixed_pixels = false;
  const RayScene scene(WallWithPillar());
  const slam::Scan mixed = TakeAtStart(WallWithPillar(), options),
                   truth = TakeAtStart(WallWithPillar(), exact);
  std::size_t at_edges = 0;
  for (std::size_t s = 0; s < mixed.sweeps.size(); ++s) {
    const slam::LaserSweep& slice = mixed.sweeps[s];
    const auto beams =
        SweepBeams(AisMounting(options), Standing({}), slice.stamp, slice.pitch, slice.pitch_rate);
    for (std::size_t b = 0; b < beams.size(); ++b) {
      const double error = std::abs(slice.ranges[b] - truth.sweeps[s].ranges[b]);
      // Twice the curvature of the most slanted surface in the cone is what is left on a plane.
      if (error < 2e-4 * truth.sweeps[s].ranges[b]) continue;
      EXPECT_GT(SpreadOf(scene, beams[b], options.range_finder.divergence), error);
      at_edges += error > 0.1 * kDepth;
    }
  }
  EXPECT_GT(at_edges, 20u) << "each edge of the pillar, in some slices";
  EXPECT_LT(at_edges, 800u);
}

TEST(MixedPixels, LieBetweenTheSurfaces) {
  const AisScannerOptions options = OnlyMixedPixels();
  const slam::Scan scan = TakeAtStart(WallWithPillar(), options);
  std::size_t between = 0;
  for (const Eigen::Vector3d& p : slam::ToPointCloud(scan).positions) {
    const double x = p.x() + options.mount_x;
    EXPECT_LT(x, 4.001);
    const bool level = std::abs(p.z()) < 0.5 && std::abs(p.y()) < 0.4;
    between += level && x > 0.5 && x > 4.0 - 0.9 * kDepth && x < 4.0 - 0.1 * kDepth &&
               std::abs(std::abs(p.y()) - kHalfWidth) < 0.03;
  }
  EXPECT_GT(between, 10u);
}

TEST(MixedPixels, NeedSurfacesWithinAPulse) {
  AisScannerOptions options = OnlyMixedPixels();
  options.range_finder.pulse_length = 0.5 * kDepth;
  const slam::Scan scan = TakeAtStart(WallWithPillar(), options);
  for (const Eigen::Vector3d& p : slam::ToPointCloud(scan).positions) {
    const double x = p.x() + options.mount_x;
    const bool on_side = std::abs(std::abs(p.y()) - kHalfWidth) < 1e-3;
    const bool level = std::abs(p.z()) < 0.5 && std::abs(p.y()) < 1.0 && p.x() > 0.0;
    if (!level || on_side) continue;
    EXPECT_TRUE(std::abs(x - 4.0) < 1e-3 || std::abs(x - 4.0 + kDepth) < 1e-3) << x;
  }
}

}  // namespace
}  // namespace ariadne::drivers
