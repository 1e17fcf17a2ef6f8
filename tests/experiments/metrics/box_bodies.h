#pragma once

#include <Eigen/Core>
#include <string>

#include "drivers/simulated/world.h"

/// Worlds of boxes for the tests of metrics.
namespace ariadne::experiments {

inline drivers::TriangleMesh BoxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  drivers::TriangleMesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                               corner & 4 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline drivers::Body Box(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {name, BoxMesh(low, high), {}, {}};
}

/// A room of 4 x 6 x 2.5 m, its corner in the origin, seen from inside; the robot starts at (1, 1).
inline drivers::World Room() { return {"room", {Box("room", {0, 0, 0}, {4, 6, 2.5})}, {0.0, {1.0, 1.0}}}; }

/// The same, with a wall of 20 cm across it at y = 3 m, which leaves a door of the given width at x = 4 m.
inline drivers::World TwoRooms(double door) {
  drivers::World world = Room();
  world.bodies.push_back(Box("wall", {0, 3, 0}, {4.0 - door, 3.2, 2.5}));
  return world;
}

/// A body that walks along x.
inline drivers::Body Walker() {
  drivers::Body body = Box("walker", {-0.2, -0.2, 0}, {0.2, 0.2, 1.8});
  body.motion = {{0.0, 10.0}, {slam::Pose3{{1, 0, 0, 0}, {1, 2, 0}}, slam::Pose3{{1, 0, 0, 0}, {3, 2, 0}}}};
  return body;
}

}  // namespace ariadne::experiments
