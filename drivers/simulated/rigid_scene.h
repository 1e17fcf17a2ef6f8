#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "drivers/simulated/world.h"

namespace ariadne::drivers {

using EmbreeDevice = std::shared_ptr<std::remove_pointer_t<RTCDevice>>;

/// A new device; it starts no threads and limits nobody else's.
EmbreeDevice MakeEmbreeDevice();

/// A mesh under the number by which hits name it. The mesh is not copied and must stay where it is.
struct NumberedMesh {
  std::uint32_t number;
  const TriangleMesh* mesh;
};

/// A half line in the frame of a RigidScene; `direction` has unit length.
struct LocalRay {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
};

/// What it meets first; mesh = kNothing: nothing.
struct LocalHit {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  double distance = std::numeric_limits<double>::infinity();  // [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();           // unit, towards the ray's origin
  std::uint32_t mesh = kNothing;
  std::uint32_t triangle = kNothing;
};

/// The point of the surfaces that is nearest to another; mesh = LocalHit::kNothing: none is near enough.
struct LocalClosest {
  double distance = std::numeric_limits<double>::infinity();  // [m]
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::uint32_t mesh = LocalHit::kNothing;
  std::uint32_t triangle = LocalHit::kNothing;
};

/// Meshes that keep their places to each other, in one Embree scene whose single-precision coordinates
/// count from the middle of the meshes: how far that is from the frame's origin does not matter.
class RigidScene {
 public:
  static constexpr std::size_t kPacket = 8;

  RigidScene(EmbreeDevice device, std::vector<NumberedMesh> meshes);

  LocalHit Cast(const LocalRay& ray) const;

  /// At most kPacket rays at once.
  void CastPacket(std::span<const LocalRay> rays, std::span<LocalHit> hits) const;

  /// The point of the surfaces nearest to p, if it is nearer than max_distance [m].
  LocalClosest Closest(const Eigen::Vector3d& p, double max_distance) const;

  const Eigen::Vector3d& center() const { return center_; }
  /// Of the sphere around the center that contains all. [m]
  double radius() const { return radius_; }

 private:
  using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, decltype(&rtcReleaseScene)>;

  void Attach(std::uint32_t geometry);
  LocalHit Refine(const LocalRay& ray, unsigned geometry, unsigned triangle, double embree_distance) const;

  EmbreeDevice device_;
  std::vector<NumberedMesh> meshes_;  // by Embree's geometry id
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  double radius_ = 0.0;
  Scene scene_;
};

}  // namespace ariadne::drivers
