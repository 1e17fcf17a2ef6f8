#pragma once

#include <Eigen/Core>
#include <vector>

#include "drivers/simulated/ray_scene.h"

namespace ariadne::experiments {

/// Where a robot can stand, and how it is decided.
struct ReachableOptions {
  double step = 0.25;            // of the grid of places on the floor z = 0 [m]
  double radius = 0.35;          // free around a place: half the robot's width of 0.6 m, and a margin [m]
  double lowest = 0.05;          // lower things are driven over [m]
  double highest = 0.9;          // of the robot, with the scanner (Sec. 2.1) [m]
  double floor_tolerance = 0.1;  // the floor must be this near z = 0: no stairs, no holes; infinite: for
                                 // meshes that come without a floor [m]
  std::size_t max_places = 1'000'000;  // a world without walls is an error
};

/// The places (z = 0) that are connected with the world's start by steps of the grid, all of them free:
/// no surface as high as the robot within the radius, table tops included, and floor under them. The start
/// itself is taken for free. Bodies that move are where they are at time 0. Turning on the spot is not
/// looked at: the robot of 80 x 60 cm passes a door lengthwise.
std::vector<Eigen::Vector3d> ReachablePlaces(const drivers::RayScene& scene,
                                             const ReachableOptions& options);

/// Of the places, the first in each square of a grid of `spacing` [m], at the height [m] of the scanner:
/// from these what can be seen from all of them is seen, but for slivers.
std::vector<Eigen::Vector3d> ViewpointsAbove(const std::vector<Eigen::Vector3d>& places, double spacing,
                                             double height);

}  // namespace ariadne::experiments
