#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "drivers/simulated/ray_scene.h"
#include "slam/base/parallel.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// The part of a world's surfaces that could have been scanned, as points spread evenly over it: each
/// stands for the same area.
struct VisibleSurface {
  std::vector<Eigen::Vector3d> points_world;
  double area = 0.0;        // visible, from either side [m^2]
  double total_area = 0.0;  // of all surfaces, with what is inside of walls [m^2]
};

struct VisibleSurfaceOptions {
  double density = 25.0;                          // points per area: one every 20 cm [1/m^2]
  double max_range = 8.0;                         // of the scanner; the LMS-200's in its finest mode [m]
  double lowest_elevation = -0.9599310885968813;  // of a beam, -55 deg: the scanner's lowest pitch [rad]
  double highest_elevation = 1.1344640137963142;  // 65 deg, together the 120 deg of the paper [rad]
  double tolerance = 1e-3;                        // a ray that ends this near to a point has met it [m]
  std::uint64_t seed = 1;
};

/// Draws points on the triangles of all standing bodies with probability by area (one in each of equal
/// parts of the total area), and keeps those to which a ray from at least one of the viewpoints arrives
/// within range and elevations. A scanner that turns with the robot sees a direction at some tilt if the
/// direction's elevation is between the extremes of its pitch. Takes long, but only once per world.
VisibleSurface FindVisibleSurface(const drivers::RayScene& scene,
                                  const std::vector<Eigen::Vector3d>& viewpoints_world,
                                  const VisibleSurfaceOptions& options, const Parallel& parallel);

/// The share of the visible surface that has a point of the map within `radius`: both by area.
struct Coverage {
  std::size_t covered = 0;  // points of the visible surface
  double share = 0.0;       // covered / all of them
  double area = 0.0;        // that is covered [m^2]
  std::vector<Eigen::Vector3d> missed_world;
};

struct CoverageOptions {
  double radius = 0.1;  // beams of the scanner are 5 to 9 cm apart at 10 m; a wall's other side may count,
                        // if the wall is thinner than this [m]
};

Coverage MeasureCoverage(const std::vector<Eigen::Vector3d>& points_map, const slam::Pose3& T_world_map,
                         const VisibleSurface& surface, const CoverageOptions& options,
                         const Parallel& parallel);

}  // namespace ariadne::experiments
