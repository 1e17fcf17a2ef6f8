#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drivers/simulated/world.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

/// A piece of a wall as seen from above, in the map frame [m].
struct FloorWall {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  bool upright = true;  // within 5 deg: a wall or furniture, not the leaf of a plant
};

/// A building at one height: what a horizontal scanner without errors sees of it. Exploration in the plane
/// costs milliseconds where 3D scans cost seconds, and what is missed is then the planner's fault alone.
struct Floor {
  std::string name;
  std::vector<FloorWall> faces;  // those inside of walls included, where bodies overlap
  slam::Pose2 T_map_start;
  bool enclosed = false;  // by walls along all four sides of the box around the faces
};

/// The cut through all bodies that stand, at a height above z = 0 [m]. Pieces in line are joined. Error
/// where nothing reaches that height.
Floor CutFloor(const drivers::World& world, double height);

}  // namespace ariadne::experiments
