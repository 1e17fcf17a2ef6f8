#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "drivers/simulated/random_room.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {

using drivers::DrawRoom;
using drivers::DrawViewpoint;
using drivers::Room;

/// Points on the surfaces of the room, where rays in random directions from the viewpoints hit them.
inline std::vector<Eigen::Vector3d> SampleSurfaces(RandomStream& stream, const Room& room,
                                                   const std::vector<Eigen::Vector3d>& viewpoints,
                                                   std::size_t count) {
  std::vector<Eigen::Vector3d> points;
  while (points.size() < count) {
    const Eigen::Vector3d& origin = viewpoints[stream() % viewpoints.size()];
    const Eigen::Vector3d direction = DrawDirection(stream);
    const std::optional<double> distance = drivers::CastRay(room.world, origin, direction);
    if (distance) points.push_back(origin + *distance * direction);
  }
  return points;
}

}  // namespace ariadne::slam
