#pragma once

#include <optional>
#include <vector>

#include "slam/geometry/box3.h"
#include "slam/geometry/pose2.h"

namespace ariadne::drivers {

/// A building of solid axis-aligned boxes: walls, floor, ceiling, furniture. Exact, and needs no files: it
/// serves the demo and the tests until they need more than boxes.
struct BoxWorld {
  std::vector<slam::Box3> solids;
};

/// Distance along the ray to the first surface [m]; nothing where the ray leaves the world.
/// `direction` has unit length; the origin must be outside of every box.
std::optional<double> CastRay(const BoxWorld& world, const Eigen::Vector3d& origin_map,
                              const Eigen::Vector3d& direction_map);

/// A corridor of 14 x 2 m with an office of 5 x 5 m on either side, doors of 1 m, height 2.7 m, with
/// tables, shelves, a pillar and radiators: what the office of the paper's experiments is made of.
BoxWorld MakeOffice();

/// Eight stops from one end of the corridor through both offices to the other end.
std::vector<slam::Pose2> OfficeTour();

}  // namespace ariadne::drivers
