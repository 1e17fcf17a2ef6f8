#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "drivers/simulated/box_world.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {

/// A room of random size with random boxes as furniture, some of them at a wall.
struct Room {
  drivers::BoxWorld world;
  Eigen::Vector3d size;  // the room is the box from 0 to here [m]
};

inline Room DrawRoom(RandomStream& stream) {
  const double x = DrawUniform(stream, 4.0, 8.0);
  const double y = DrawUniform(stream, 4.0, 7.0);
  const double z = DrawUniform(stream, 2.5, 3.2);
  Room room{{}, {x, y, z}};
  const auto add = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    room.world.solids.emplace_back(low, high);
  };
  add({-1.0, -1.0, -0.2}, {x + 1.0, y + 1.0, 0.0});  // floor, ceiling, four walls
  add({-1.0, -1.0, z}, {x + 1.0, y + 1.0, z + 0.2});
  add({-0.2, -1.0, 0.0}, {0.0, y + 1.0, z});
  add({x, -1.0, 0.0}, {x + 0.2, y + 1.0, z});
  add({-1.0, -0.2, 0.0}, {x + 1.0, 0.0, z});
  add({-1.0, y, 0.0}, {x + 1.0, y + 0.2, z});
  const auto pieces = static_cast<int>(DrawUniform(stream, 6.0, 12.0));
  for (int i = 0; i < pieces; ++i) {
    double length = DrawUniform(stream, 0.3, 1.6);
    double depth = DrawUniform(stream, 0.3, 0.9);
    const double height = DrawUniform(stream, 0.4, 2.2);
    if (DrawUniform(stream, 0.0, 1.0) < 0.5) std::swap(length, depth);
    Eigen::Vector3d corner(DrawUniform(stream, 0.0, x - length), DrawUniform(stream, 0.0, y - depth), 0.0);
    const double place = DrawUniform(stream, 0.0, 4.0);
    if (place < 2.0) corner[static_cast<int>(place)] = 0.0;  // half of them stand at a wall
    add(corner, corner + Eigen::Vector3d(length, depth, height));
  }
  return room;
}

/// A place for a scanner: at its height, and not within anything.
inline Eigen::Vector3d DrawViewpoint(RandomStream& stream, const Room& room) {
  constexpr double kToWall = 0.6, kClearance = 0.1;
  for (;;) {
    const Eigen::Vector3d p =
        DrawInBox(stream, {kToWall, kToWall, 0.9}, {room.size.x() - kToWall, room.size.y() - kToWall, 1.3});
    const bool is_free = std::ranges::all_of(
        room.world.solids, [&](const Box3& solid) { return solid.exteriorDistance(p) > kClearance; });
    if (is_free) return p;
  }
}

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
