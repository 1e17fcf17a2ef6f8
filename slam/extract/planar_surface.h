#pragma once

#include <vector>

#include "slam/geometry/box3.h"
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

/// Of its outlines, without their holes [m^2].
double Area(const PlanarSurface& surface);

/// The same surface in frame a. Covariance and outlines are in the frame of the plane, and remain.
PlanarSurface Transformed(const Pose3& T_a_b, PlanarSurface surface_b);

/// The corners of each ring, those of holes after those of their outer ring, in the frame of the surface.
std::vector<std::vector<Eigen::Vector3d>> OutlinePoints(const PlanarSurface& surface);

/// Around the outlines; empty without any.
Box3 BoxAround(const PlanarSurface& surface);

/// A point's place in the plane, along x and y of the plane frame [m].
Eigen::Vector2d InPlane(const PlanarSurface& surface, const Eigen::Vector3d& p);

/// Whether a point, put onto the plane, is within one of the outlines.
bool IsWithinOutline(const PlanarSurface& surface, const Eigen::Vector3d& p);

/// The plane frame at a place with this unit normal: z is the normal, and x is level (forward where
/// everything in the plane is).
Pose3 PlaneFrame(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);

}  // namespace ariadne::slam
