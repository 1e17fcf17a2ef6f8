#include "drivers/simulated/box_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam/geometry/angles.h"

namespace ariadne::drivers {
namespace {

constexpr double kHeight = 2.7;  // of the ceiling [m]

slam::Box3 BoxFromTo(double x0, double x1, double y0, double y1, double z0, double z1) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

/// Distance to the entry into a box, by clipping the ray with its three slabs; infinity for a miss.
double EntryDistance(const slam::Box3& box, const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& direction) {
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  double enter = -kMiss;
  double leave = kMiss;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) {
      if (origin[axis] < box.min()[axis] || origin[axis] > box.max()[axis]) return kMiss;
      continue;
    }
    const double a = (box.min()[axis] - origin[axis]) / direction[axis];
    const double b = (box.max()[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter > 0.0 && enter <= leave ? enter : kMiss;
}

/// A wall along x at y0..y1 from x0 to x1, with door gaps of full height 2.0 m and a lintel above.
void AddWallWithDoor(std::vector<slam::Box3>& solids, double x0, double x1, double y0, double y1,
                     double door_x) {
  constexpr double kDoorWidth = 1.0, kDoorHeight = 2.0;
  solids.push_back(BoxFromTo(x0, door_x, y0, y1, 0.0, kHeight));
  solids.push_back(BoxFromTo(door_x + kDoorWidth, x1, y0, y1, 0.0, kHeight));
  solids.push_back(BoxFromTo(door_x, door_x + kDoorWidth, y0, y1, kDoorHeight, kHeight));
}

void AddTable(std::vector<slam::Box3>& solids, double x, double y, double length, double width) {
  constexpr double kLeg = 0.06, kTop = 0.74;
  solids.push_back(BoxFromTo(x, x + length, y, y + width, kTop - 0.04, kTop));
  for (const double lx : {x, x + length - kLeg}) {
    for (const double ly : {y, y + width - kLeg}) {
      solids.push_back(BoxFromTo(lx, lx + kLeg, ly, ly + kLeg, 0.0, kTop - 0.04));
    }
  }
}

void AddFurniture(std::vector<slam::Box3>& solids) {
  AddTable(solids, 1.6, 4.2, 1.6, 0.8);
  AddTable(solids, 4.0, 2.4, 0.8, 1.6);
  AddTable(solids, 8.4, -5.2, 1.6, 0.8);
  solids.push_back(BoxFromTo(1.0, 1.35, 2.0, 3.6, 0.0, 1.9));       // shelf in the left office
  solids.push_back(BoxFromTo(5.2, 6.0, 5.6, 6.0, 0.0, 1.2));        // cupboard
  solids.push_back(BoxFromTo(11.6, 12.0, -4.0, -2.4, 0.0, 2.1));    // shelf in the right office
  solids.push_back(BoxFromTo(7.0, 7.5, -1.9, -1.5, 0.0, 0.8));      // cabinet behind the door
  solids.push_back(BoxFromTo(9.6, 9.9, -3.4, -3.1, 0.0, kHeight));  // pillar
  solids.push_back(BoxFromTo(2.5, 4.1, 5.88, 6.0, 0.15, 0.75));     // radiators below the windows
  solids.push_back(BoxFromTo(8.2, 9.8, -6.0, -5.88, 0.15, 0.75));
  solids.push_back(BoxFromTo(3.0, 3.9, -1.0, -0.65, 0.0, 1.1));  // copier in the corridor
  solids.push_back(BoxFromTo(11.0, 11.5, 0.8, 1.0, 0.0, 1.8));   // fire cabinet
}

}  // namespace

std::optional<double> CastRay(const BoxWorld& world, const Eigen::Vector3d& origin_map,
                              const Eigen::Vector3d& direction_map) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const slam::Box3& solid : world.solids) {
    nearest = std::min(nearest, EntryDistance(solid, origin_map, direction_map));
  }
  if (std::isinf(nearest)) return std::nullopt;
  return nearest;
}

BoxWorld MakeOffice() {
  // Corridor x 0..14, y -1..1; left office x 1..6, y 1..6; right office x 7..12, y -6..-1.
  constexpr double kWall = 0.15;
  std::vector<slam::Box3> solids;
  solids.push_back(BoxFromTo(-1.0, 15.0, -7.0, 7.0, -0.2, 0.0));               // floor
  solids.push_back(BoxFromTo(-1.0, 15.0, -7.0, 7.0, kHeight, kHeight + 0.2));  // ceiling
  solids.push_back(BoxFromTo(-kWall, 0.0, -1.0 - kWall, 1.0 + kWall, 0.0, kHeight));
  solids.push_back(BoxFromTo(14.0, 14.0 + kWall, -1.0 - kWall, 1.0 + kWall, 0.0, kHeight));
  AddWallWithDoor(solids, 0.0, 14.0, 1.0, 1.0 + kWall, 2.6);
  AddWallWithDoor(solids, 0.0, 14.0, -1.0 - kWall, -1.0, 10.2);
  for (const double x : {1.0 - kWall, 6.0})
    solids.push_back(BoxFromTo(x, x + kWall, 1.0, 6.0, 0.0, kHeight));
  for (const double x : {7.0 - kWall, 12.0})
    solids.push_back(BoxFromTo(x, x + kWall, -6.0, -1.0, 0.0, kHeight));
  solids.push_back(BoxFromTo(0.8, 6.2, 6.0, 6.0 + kWall, 0.0, kHeight));
  solids.push_back(BoxFromTo(6.8, 12.2, -6.0 - kWall, -6.0, 0.0, kHeight));
  AddFurniture(solids);
  return {solids};
}

std::vector<slam::Pose2> OfficeTour() {
  const auto stop = [](double x, double y, double heading_deg) {
    return slam::Pose2{slam::RadFromDeg(heading_deg), {x, y}};
  };
  return {stop(0.8, 0.0, 0.0), stop(3.1, 0.1, 60.0),   stop(3.1, 2.6, 80.0),     stop(3.4, 0.0, 0.0),
          stop(6.5, 0.1, 0.0), stop(10.6, 0.0, -60.0), stop(10.6, -2.2, -110.0), stop(11.5, 0.0, 0.0)};
}

}  // namespace ariadne::drivers
