#pragma once

#include <Eigen/Core>

namespace ariadne::drivers {

struct Triangle {
  Eigen::Vector3d a, b, c;
};

/// The point of the triangle, border included, that is nearest to p. A triangle without area is the line or
/// the point that its corners span.
Eigen::Vector3d ClosestPoint(const Triangle& triangle, const Eigen::Vector3d& p);

}  // namespace ariadne::drivers
