#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "drivers/simulated/surface_distance.h"
#include "drivers/simulated/world.h"
#include "slam/base/parallel.h"
#include "slam/geometry/plane3.h"

namespace ariadne::experiments {

inline constexpr std::uint32_t kNoWall = std::numeric_limits<std::uint32_t>::max();

/// A flat, connected part of the true surfaces: a side of a wall or of a shelf; if asked for, a floor.
struct WallFace {
  slam::Plane3 plane_world;  // of the largest triangle
  double area = 0.0;         // [m^2]
};

/// The faces of a world, and to which of them its triangles belong.
struct WallFaces {
  std::vector<WallFace> faces;
  std::vector<std::vector<std::uint32_t>> face_of;  // [body][triangle] -> index into faces, or kNoWall
};

struct WallFaceOptions {
  double min_area = 0.5;       // smaller faces are no walls [m^2]
  double max_tilt = 0.0873;    // of a wall from the vertical, 5 deg; pi/2: floors and ceilings too [rad]
  double max_angle = 0.00873;  // between the normals of neighbours in one face: half a degree [rad]
  double max_offset = 0.002;   // of a corner from the plane of the face's largest triangle [m]
  double weld = 1e-4;          // corners closer than this are one: many meshes repeat theirs [m]
};

/// Grows faces from the largest triangles on, over shared edges, as long as angle and offset to the first
/// triangle allow. Bodies that move have no faces; triangles of different bodies are never joined.
WallFaces FindWallFaces(const drivers::World& world, const WallFaceOptions& options);

/// For each point the face that its nearest surface belongs to, if that is within `gate` [m]; else kNoWall.
///
/// Two ways to use it. With the points of the scans at their *true* poses, and a gate just above the
/// scanner's error, it says which wall each beam has met; the errors of a map do not touch it, so that even
/// a wall that the map shows half a metre off is measured in full. With the points of a *map*, where
/// nothing else is known, the gate (10 to 15 cm) cuts off what is farther, and points may fall to the other
/// side of a thin wall: thick walls then look thinner than they are.
std::vector<std::uint32_t> AssignToWalls(const std::vector<Eigen::Vector3d>& points_world,
                                         const WallFaces& walls, const drivers::SurfaceDistance& surface,
                                         double gate, const Parallel& parallel);

}  // namespace ariadne::experiments
