#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ariadne::slam {

/// A straight piece of a slice: the line normal . p = offset with normal = (cos angle, sin angle), between
/// two end points. All of it is in the frame of the slice: its plane, the scanner at the origin, x forward
/// and y to the left. The normal points away from the scanner (offset >= 0), which sees the segment run
/// from its right to its left.
struct LineSegment {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  // right end: the outermost point, put onto the line [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    // left end [m]
  double angle = 0.0;                              // of the normal, in (-pi, pi] [rad]
  double offset = 0.0;                             // of the line from the scanner [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (angle, offset) [rad, m]
  double rms = 0.0;                                      // distance of the points from the line [m]
  std::vector<std::size_t> points;                       // those that it explains, ascending

  double Length() const { return (to - from).norm(); }
  Eigen::Vector2d Normal() const { return {std::cos(angle), std::sin(angle)}; }
  /// Signed, positive beyond the line as seen from the scanner. [m]
  double Distance(const Eigen::Vector2d& p) const { return Normal().dot(p) - offset; }
};

/// The edge points of a slice (Fig. 5): the end points of its lines, `from` and `to` of each in turn.
std::vector<Eigen::Vector2d> EdgePoints(std::span<const LineSegment> segments);

/// Throws an Error that names the first point with a coordinate that is NaN or infinite.
void RequireFinite(std::span<const Eigen::Vector2d> points);

}  // namespace ariadne::slam
