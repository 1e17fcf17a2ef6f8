#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>

#include "drivers/simulated/world.h"

namespace ariadne::drivers {

/// The point of a world's surfaces that is nearest to another.
struct ClosestSurface {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  // never negative [m]
  Eigen::Vector3d point_map = Eigen::Vector3d::Zero();
  std::uint32_t body = kNothing;      // index into World::bodies
  std::uint32_t triangle = kNothing;  // index into that body's mesh

  bool found() const { return body != kNothing; }
};

/// Distances to the true surfaces of a world, by Embree's point queries; each triangle that Embree, in
/// single precision, finds near is measured in double precision, so that the distance is exact. Bodies that
/// move are left out: a map should not hold them. Queries are thread-safe, and give the same answers
/// whatever the number of threads.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const World& world);
  ~SurfaceDistance();
  SurfaceDistance(SurfaceDistance&&) noexcept;
  SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

  /// The nearest surface, if it is nearer than max_distance [m].
  ClosestSurface Closest(const Eigen::Vector3d& p_map,
                         double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ariadne::drivers
