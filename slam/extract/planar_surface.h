#pragma once

#include <vector>

#include "slam/geometry/plane3.h"
#include "slam/geometry/polygon2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// A flat piece of a surface that was seen. `frame` is the laser's, or the map's after Transformed.
struct PlanarSurface {
  Pose3 T_frame_plane;  // origin: mean of the points; z: the normal, towards the scanner; x: level
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of turns about x and y [rad], shift along z [m]
  std::vector<Polygon2> outlines;                        // in x and y of the plane frame [m]
  double rms = 0.0;                                      // distance of the points from the plane [m]
  std::size_t points = 0;                                // that it explains
};

inline Plane3 PlaneOf(const PlanarSurface& surface) {
  const Eigen::Vector3d normal = surface.T_frame_plane.rotation * Eigen::Vector3d::UnitZ();
  return {normal, normal.dot(surface.T_frame_plane.translation)};
}

}  // namespace ariadne::slam
