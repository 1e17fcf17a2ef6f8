#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "slam/geometry/pose2.h"

namespace ariadne::drivers {

/// A convex polygon in the plane; with a single corner a point, with two, or with all in line, a stretch.
class Outline {
 public:
  void Add(const Eigen::Vector2d& corner) { corners_[count_++] = corner; }
  std::span<const Eigen::Vector2d> corners() const { return {corners_.data(), count_}; }
  bool empty() const { return count_ == 0; }

 private:
  std::array<Eigen::Vector2d, 5> corners_;  // a triangle that two parallel planes cut has no more
  std::size_t count_ = 0;
};

/// Heights above the floor [m].
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

/// What a triangle looks like from above, between two heights; empty where it is not between them.
Outline OutlineBetween(const std::array<Eigen::Vector3d, 3>& triangle, const HeightRange& heights);

/// How far a rectangle must be shifted until it is free of the outline, at least [m]; 0: it is free, or
/// touches. The rectangle is centered in the base frame; `half_size` is along x and along y [m]. Exact, by
/// separating axes.
double OverlapDepth(const Outline& outline_map, const slam::Pose2& T_map_base,
                    const Eigen::Vector2d& half_size);

/// How far a point is from the outline [m]; 0: inside. Infinite where the outline is empty.
double DistanceTo(const Outline& outline_map, const Eigen::Vector2d& p_map);

}  // namespace ariadne::drivers
