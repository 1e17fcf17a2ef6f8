#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace ariadne::slam {

/// Count, mean and scatter of points, in double: what an octree computes with, not what it stores.
struct CellMoments {
  std::uint64_t count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // relative to an origin that both of a merge share [m]
  /// Sum of (p - mean)(p - mean)^T: xx, xy, xz, yy, yz, zz [m^2]
  std::array<double, 6> scatter{};
  double reflectance = 0.0;  // mean
  std::uint32_t view = 0xFFFFFFFF;

  Eigen::Matrix3d Scatter() const;
};

/// Of both sets of points together (Chan's update: no large sums are subtracted).
CellMoments Merged(const CellMoments& a, const CellMoments& b);

/// From where a place p was seen, as a number that is smaller for a nearer viewpoint: squared distance (to
/// 1/256) above the direction (to 1 deg). The smallest of several does not depend on their order.
std::uint32_t ViewCode(const Eigen::Vector3d& viewpoint_from_p);
/// The direction of a code, unit length.
Eigen::Vector3d ViewDirection(std::uint32_t view);

/// Across the surface that the moments show, towards the viewpoint; zero where the points do not span a
/// plane.
Eigen::Vector3d NormalOf(const CellMoments& moments);

/// The same in 48 bytes, which is what hundreds of millions of points are boiled down to. The mean is
/// stored as offset from the leaf's center, so that 24 bits resolve nanometres.
class OctreeLeaf {
 public:
  OctreeLeaf() = default;
  CellMoments Moments() const;
  std::uint32_t count() const { return count_; }

  /// More points of the same leaf, seen from a viewpoint. What `more` says of the view does not count.
  void Add(const CellMoments& more_center, const Eigen::Vector3d& viewpoint_from_center);

 private:
  void Store(const CellMoments& moments_center);

  std::array<float, 3> mean_{};
  std::array<float, 6> scatter_{};
  float reflectance_ = 0.0F;
  std::uint32_t count_ = 0;  // stays at its largest value where more points come
  std::uint32_t view_ = 0xFFFFFFFF;
};

static_assert(sizeof(OctreeLeaf) == 48);

}  // namespace ariadne::slam
