#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "drivers/simulated/world.h"

namespace ariadne::experiments {

/// Points spread evenly over the surfaces of a world: each stands for the same area.
struct SurfaceSamples {
  std::vector<Eigen::Vector3d> points_world;
  double area = 0.0;  // of all triangles of bodies that stand [m^2]
};

/// The total area is cut into equal parts of 1 / density [m^2], along the list of triangles; in each part
/// one point is drawn uniformly (stratified sampling), so that even single walls get their share.
SurfaceSamples SampleSurface(const drivers::World& world, double density, std::uint64_t seed);

}  // namespace ariadne::experiments
