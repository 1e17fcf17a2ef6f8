#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace ariadne::slam {

/// An axis-aligned box. Eigen's own type has what is needed: extend, contains, intersects,
/// exteriorDistance.
using Box3 = Eigen::AlignedBox3d;

/// The smallest box around the points; empty without points.
inline Box3 BoxAround(const std::vector<Eigen::Vector3d>& points) {
  Box3 box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  return box;
}

}  // namespace ariadne::slam
