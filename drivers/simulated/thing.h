#pragma once

#include <string>
#include <vector>

#include "drivers/simulated/solids.h"

namespace ariadne::drivers {

/// What of a thing is made of one material.
struct Part {
  std::string material;  // by name: the world says what it reflects
  TriangleMesh mesh;
};

/// A thing in its own frame: on the floor z = 0, around the origin, its front towards +x; lengths in m.
using Thing = std::vector<Part>;

inline TriangleMesh BoxBetween(double x0, double y0, double z0, double x1, double y1, double z1) {
  return MakeBox(slam::Box3(Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)));
}

}  // namespace ariadne::drivers
