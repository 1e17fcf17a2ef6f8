#pragma once

#include <string>
#include <vector>

#include "drivers/simulated/floor_plan.h"
#include "drivers/simulated/plan_world.h"
#include "drivers/simulated/thing.h"
#include "slam/geometry/pose2.h"

namespace ariadne::drivers {

struct PlacedThing {
  std::string name;
  Thing thing;
  slam::Pose2 T_map_thing;
};

/// Furniture for the rooms of a plan, the same for the same seed: shelves and cupboards stand at walls,
/// tables with chairs in the room; doors, the start, and a way between the pieces stay free. Corridors stay
/// empty.
std::vector<PlacedThing> FurnishPlan(const FloorPlan& plan, const std::vector<PlanWall>& walls,
                                     const PlanOptions& options);

}  // namespace ariadne::drivers
