#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace ariadne::drivers {

struct PlanWall {
  Eigen::Vector2d from, to;  // [m]

  double length() const { return (to - from).norm(); }
  Eigen::Vector2d direction() const { return (to - from).normalized(); }
};

struct PlanSpace {
  std::string label;
  std::vector<Eigen::Vector2d> outline;
};

/// The lines of a floor plan, as its file has them.
struct FloorPlan {
  std::string name;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  std::vector<PlanWall> walls;
  std::vector<Eigen::Vector2d> doors;
  std::vector<PlanSpace> spaces;
};

/// Reads the JSON of data/plans. An Error names the place in the file: line and column of a syntax error,
/// else the element, as in walls[12].
FloorPlan ParseFloorPlan(const std::string& text, const std::string& name_for_errors);

/// The walls without repetition: rooms that share one draw it twice, or in overlapping pieces.
std::vector<PlanWall> MergeWalls(const std::vector<PlanWall>& walls);

/// Where walls end at a door, from one end of a wall to what stands opposite.
std::vector<PlanWall> FindDoorways(const std::vector<PlanWall>& walls,
                                   const std::vector<Eigen::Vector2d>& doors);

bool IsInside(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p);

/// Whether one side of a doorway is in none of the spaces; false where a plan has no spaces.
bool LeadsOutside(const PlanWall& doorway, const std::vector<PlanSpace>& spaces);

}  // namespace ariadne::drivers
