#pragma once

#include <span>

#include "slam/geometry/box3.h"
#include "slam/geometry/triangle_mesh.h"

namespace ariadne::experiments {

// What is drawn into a mesh, so that surfaces in front of it hide it.

/// Adds a mesh in one colour.
void AppendPainted(slam::TriangleMesh& mesh, slam::TriangleMesh part, slam::Rgb color);

/// A round bar between two places.
void AppendBar(slam::TriangleMesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
               double radius, slam::Rgb color);

/// A line as a tube with round joints; places that coincide with the one before are left out.
void AppendTube(slam::TriangleMesh& mesh, std::span<const Eigen::Vector3d> line, double radius,
                slam::Rgb color);

/// The twelve edges of a box.
void AppendBoxEdges(slam::TriangleMesh& mesh, const slam::Box3& box, double radius, slam::Rgb color);

}  // namespace ariadne::experiments
