#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "drivers/simulated/world.h"

namespace ariadne::drivers {

/// A half line from the scanner into the world, at a time: moving bodies are where they are then.
struct Ray {
  Eigen::Vector3d origin_map;
  Eigen::Vector3d direction_map;  // unit length
  double time = 0.0;              // [s]
};

/// What a ray meets first.
struct Hit {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  // along the ray [m]
  Eigen::Vector3d normal_map = Eigen::Vector3d::Zero();  // of the surface, unit, towards the ray's origin
  std::uint32_t body = kNothing;                         // index into World::bodies
  std::uint32_t triangle = kNothing;                     // index into that body's mesh
  double reflectance = 0.0;                              // of the body's material

  bool hit() const { return body != kNothing; }
};

/// The world as a bounding-volume hierarchy (Embree), ready for rays. Casting is thread-safe, and gives the
/// same hits whatever the number of threads. Distances are exact to double precision for the triangle that
/// Embree, in single precision, says is the nearest: it is intersected once more.
class RayScene {
 public:
  explicit RayScene(World world);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  const World& world() const;

  Hit Cast(const Ray& ray) const;

  /// The same for many rays, faster where neighbours are alike; hits.size() == rays.size().
  void Cast(std::span<const Ray> rays, std::span<Hit> hits) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ariadne::drivers
