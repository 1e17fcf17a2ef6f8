#include "slam/extract/planar_surface.h"

#include <algorithm>
#include <utility>

namespace ariadne::slam {
namespace {

constexpr double kLevelPlane = 1e-9;  // sine to the horizontal, below which all directions are level

std::vector<Eigen::Vector3d> InSpace(const Pose3& T_frame_plane, const Ring& ring) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(ring.size());
  for (const Eigen::Vector2d& q : ring)
    points.push_back(T_frame_plane * Eigen::Vector3d(q.x(), q.y(), 0.0));
  return points;
}

}  // namespace

double Area(const PlanarSurface& surface) {
  double area = 0.0;
  for (const Polygon2& outline : surface.outlines) area += Area(outline);
  return area;
}

PlanarSurface Transformed(const Pose3& T_a_b, PlanarSurface surface_b) {
  surface_b.T_frame_plane = T_a_b * surface_b.T_frame_plane;
  return surface_b;
}

std::vector<std::vector<Eigen::Vector3d>> OutlinePoints(const PlanarSurface& surface) {
  std::vector<std::vector<Eigen::Vector3d>> rings;
  for (const Polygon2& outline : surface.outlines) {
    rings.push_back(InSpace(surface.T_frame_plane, outline.outer));
    for (const Ring& hole : outline.holes) rings.push_back(InSpace(surface.T_frame_plane, hole));
  }
  return rings;
}

Box3 BoxAround(const PlanarSurface& surface) {
  Box3 box;
  for (const std::vector<Eigen::Vector3d>& ring : OutlinePoints(surface)) box.extend(BoxAround(ring));
  return box;
}

Eigen::Vector2d InPlane(const PlanarSurface& surface, const Eigen::Vector3d& p) {
  const Pose3& T = surface.T_frame_plane;
  return (T.rotation.conjugate() * (p - T.translation)).head<2>();
}

bool IsWithinOutline(const PlanarSurface& surface, const Eigen::Vector3d& p) {
  const Eigen::Vector2d q = InPlane(surface, p);
  return std::ranges::any_of(surface.outlines,
                             [&](const Polygon2& outline) { return Contains(outline, q); });
}

Pose3 PlaneFrame(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
  Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(normal);
  if (x.norm() < kLevelPlane) x = Eigen::Vector3d::UnitX() - normal.x() * normal;
  Eigen::Matrix3d axes;
  axes.col(0) = x.normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return {Eigen::Quaterniond(axes).normalized(), origin};
}

}  // namespace ariadne::slam
