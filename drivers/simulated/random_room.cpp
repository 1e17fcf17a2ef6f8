#include "drivers/simulated/random_room.h"

#include <algorithm>
#include <utility>

#include "drivers/simulated/solids.h"

namespace ariadne::drivers {
namespace {

/// Floor, ceiling and four walls around the box from 0 to `size`.
std::vector<slam::Box3> Shell(const Eigen::Vector3d& size) {
  const double x = size.x(), y = size.y(), z = size.z();
  std::vector<slam::Box3> solids;
  const auto add = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    solids.emplace_back(low, high);
  };
  add({-1.0, -1.0, -0.2}, {x + 1.0, y + 1.0, 0.0});
  add({-1.0, -1.0, z}, {x + 1.0, y + 1.0, z + 0.2});
  add({-0.2, -1.0, 0.0}, {0.0, y + 1.0, z});
  add({x, -1.0, 0.0}, {x + 0.2, y + 1.0, z});
  add({-1.0, -0.2, 0.0}, {x + 1.0, 0.0, z});
  add({-1.0, y, 0.0}, {x + 1.0, y + 0.2, z});
  return solids;
}

slam::Box3 DrawFurniture(RandomStream& stream, const Eigen::Vector3d& size) {
  double length = DrawUniform(stream, 0.3, 1.6);
  double depth = DrawUniform(stream, 0.3, 0.9);
  const double height = DrawUniform(stream, 0.4, 2.2);
  if (DrawUniform(stream, 0.0, 1.0) < 0.5) std::swap(length, depth);
  const double y = DrawUniform(stream, 0.0, size.y() - depth);
  const double x = DrawUniform(stream, 0.0, size.x() - length);
  Eigen::Vector3d corner(x, y, 0.0);
  const double place = DrawUniform(stream, 0.0, 4.0);
  if (place < 2.0) corner[static_cast<int>(place)] = 0.0;  // half of them stand at a wall
  return {corner, corner + Eigen::Vector3d(length, depth, height)};
}

}  // namespace

Room DrawRoom(RandomStream& stream) {
  const double x = DrawUniform(stream, 4.0, 8.0);
  const double y = DrawUniform(stream, 4.0, 7.0);
  const double z = DrawUniform(stream, 2.5, 3.2);
  Room room{{}, {x, y, z}};
  room.world.solids = Shell(room.size);
  const auto pieces = static_cast<int>(DrawUniform(stream, 6.0, 12.0));
  for (int i = 0; i < pieces; ++i) room.world.solids.push_back(DrawFurniture(stream, room.size));
  return room;
}

Eigen::Vector3d DrawViewpoint(RandomStream& stream, const Room& room) {
  constexpr double kToWall = 0.6, kClearance = 0.1, kLowest = 0.9, kHighest = 1.3;
  for (;;) {
    const double x = DrawUniform(stream, kToWall, room.size.x() - kToWall);
    const double y = DrawUniform(stream, kToWall, room.size.y() - kToWall);
    const Eigen::Vector3d p(x, y, DrawUniform(stream, kLowest, kHighest));
    const bool is_free = std::ranges::all_of(
        room.world.solids, [&](const slam::Box3& solid) { return solid.exteriorDistance(p) > kClearance; });
    if (is_free) return p;
  }
}

World ToWorld(const Room& room) {
  World world;
  for (const slam::Box3& solid : room.world.solids) {
    world.bodies.push_back({"solid", MakeBox(solid), {}, {}});
  }
  return world;
}

}  // namespace ariadne::drivers
