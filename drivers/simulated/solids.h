#pragma once

#include <Eigen/Core>
#include <vector>

#include "drivers/simulated/world.h"
#include "slam/geometry/box3.h"

namespace ariadne::drivers {

/// Closed meshes, their triangles counterclockwise seen from outside. Lengths in m.

TriangleMesh MakeBox(const slam::Box3& box);

/// The solid above a simple polygon (either orientation, not closed by repeating its first corner).
TriangleMesh MakePrism(const std::vector<Eigen::Vector2d>& outline, double bottom, double top);

/// A corner (distance from the axis, height) of what a lathe cuts.
using ProfilePoint = Eigen::Vector2d;

/// What a profile sweeps when it turns around the vertical axis through the origin. The profile starts and
/// ends on the axis and runs so that the solid lies to its left: from the lowest point upwards.
TriangleMesh MakeRevolved(const std::vector<ProfilePoint>& profile, int sides);

/// Upright on the plane z = 0; the corners lie on the circle.
TriangleMesh MakeCylinder(double radius, double height, int sides = 32);

TriangleMesh MakeEllipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii, int sides = 20);

/// A round bar between two points, as thick as is given at either end.
TriangleMesh MakeRod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
                     double radius_to, int sides = 12);

TriangleMesh Moved(TriangleMesh mesh, const slam::Pose3& T_to_from);

/// Whether each edge is shared by two triangles that run along it in opposite directions.
bool IsClosed(const TriangleMesh& mesh);

/// Enclosed by a closed mesh [m^3]; negative where it is inside out.
double Volume(const TriangleMesh& mesh);

/// The triangles of a simple polygon, counterclockwise, as indices of its corners. An Error where the
/// outline crosses itself or encloses nothing.
std::vector<std::array<std::uint32_t, 3>> Triangulate(const std::vector<Eigen::Vector2d>& outline);

}  // namespace ariadne::drivers
