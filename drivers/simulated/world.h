#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"
#include "slam/geometry/triangle_mesh.h"

namespace ariadne::drivers {

using slam::TriangleMesh;

/// What a surface does with the scanner's light.
struct Material {
  double reflectance = 0.6;  // share of the light that a diffuse surface returns, 1 is white paper
};

/// Where a body is over time: between two key frames it goes straight and turns evenly; before the first
/// and after the last it stands.
struct Motion {
  std::vector<double> times;  // ascending [s]
  std::vector<slam::Pose3> T_map_body;

  bool moves() const { return times.size() > 1; }
};

/// One rigid thing of a world: the building, a table, a walking person.
struct Body {
  std::string name;
  TriangleMesh mesh_body;
  Material material;
  Motion motion;  // empty: the body's frame is the map's
};

/// A building that is known exactly, and where the robot starts in it.
struct World {
  std::string name;
  std::vector<Body> bodies;
  slam::Pose2 T_map_start;  // of the robot's base, on the floor z = 0
};

/// The pose of a body at a time [s].
slam::Pose3 PoseAt(const Motion& motion, double time);

/// The mesh of a body in map coordinates at a time [s].
TriangleMesh MeshAt(const Body& body, double time);

/// Throws an Error that begins with the body's name where key frames are missing, not finite or not
/// ascending.
void RequireSound(const Motion& motion, const std::string& name);

}  // namespace ariadne::drivers
