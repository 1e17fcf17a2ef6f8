#include "drivers/simulated/plan_world.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/simulated/building.h"
#include "drivers/simulated/floor_plan.h"
#include "drivers/simulated/plan_furniture.h"
#include "drivers/simulated/thing_kinds.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector2d;

void Add(const std::string& name, Thing thing, const slam::Pose3& T_map_thing, World& world) {
  for (Part& part : thing) {
    if (part.mesh.triangles.empty()) continue;
    world.bodies.push_back({fmt::format("{}/{}", name, part.material),
                            Moved(std::move(part.mesh), T_map_thing),
                            {CommonMaterials().at(part.material)},
                            {}});
  }
}

slam::Pose3 Along(const PlanWall& wall) {
  const Vector2d u = wall.direction();
  return ToPose3(slam::Pose2{std::atan2(u.y(), u.x()), wall.from});
}

/// Walls are half their thickness longer than their lines, so that corners are full; not at doorways.
PlanWall Lengthened(const PlanWall& wall, const std::vector<PlanWall>& doorways, double by) {
  const auto at_doorway = [&](const Vector2d& end) {
    return std::ranges::any_of(doorways, [&](const PlanWall& d) {
      return (d.from - end).norm() < 0.02 || (d.to - end).norm() < 0.02;
    });
  };
  PlanWall longer = wall;
  if (!at_doorway(wall.from)) longer.from -= by * wall.direction();
  if (!at_doorway(wall.to)) longer.to += by * wall.direction();
  return longer;
}

Wall WallOf(const PlanWall& line, const PlanOptions& options) {
  Wall wall;
  wall.length = line.length();
  wall.thickness = options.thickness;
  wall.height = options.height;
  return wall;
}

/// Lintel and frame of a doorway, wall beside it where it is to be narrower, and a leaf where it is closed.
Wall DoorwayOf(const PlanWall& line, bool closed, const PlanOptions& options) {
  Wall wall = WallOf(line, options);
  Opening opening;
  opening.at = 0.5 * wall.length;
  opening.width = options.door_width > 0.0 ? std::min(options.door_width, wall.length) : wall.length;
  opening.top = std::min(options.door_height, options.height);
  opening.frame = opening.top < options.height ? 0.015 : 0.0;
  if (closed) opening.hinge = Hinge::kStart;
  wall.openings = {opening};
  return wall;
}

/// Floor, ceiling, and a yard wall a metre around the building: some plans are open somewhere, and a robot
/// that finds out must not leave the world.
void AddShell(const std::vector<PlanWall>& walls, double height, World& world) {
  Eigen::AlignedBox2d box;
  for (const PlanWall& wall : walls) box.extend(wall.from).extend(wall.to);
  const Vector2d low = box.min() - Vector2d(1.0, 1.0), high = box.max() + Vector2d(1.0, 1.0);
  const auto slab = [&](double bottom, double top) {
    return BoxBetween(low.x(), low.y(), bottom, high.x(), high.y(), top);
  };
  Add("floor", {{"linoleum", slab(-0.2, 0.0)}}, {}, world);
  Add("ceiling", {{"plaster", slab(height, height + 0.2)}}, {}, world);
  constexpr double kYardWall = 0.2;
  const std::vector<Vector2d> corners{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (std::size_t i = 0; i < 4; ++i) {
    const slam::Box3 side = slam::BoxAround({{corners[i].x(), corners[i].y(), 0.0},
                                             {corners[(i + 1) % 4].x(), corners[(i + 1) % 4].y(), height}});
    const Eigen::Vector3d half(0.5 * kYardWall, 0.5 * kYardWall, 0.0);
    Add(fmt::format("yard wall {}", i), {{"brick", MakeBox({side.min() - half, side.max() + half})}}, {},
        world);
  }
}

}  // namespace

World ParsePlan(const std::string& text, const std::string& name_for_errors, const PlanOptions& options) {
  CheckOptions(options, "plan.");
  const FloorPlan plan = ParseFloorPlan(text, name_for_errors);
  const std::vector<PlanWall> walls = MergeWalls(plan.walls);
  if (walls.empty()) Fail("{}: the plan has no walls", name_for_errors);
  const std::vector<PlanWall> doorways = FindDoorways(walls, plan.doors);
  World world{plan.name, {}, {0.0, plan.start}};
  AddShell(walls, options.height, world);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const PlanWall line = Lengthened(walls[i], doorways, 0.5 * options.thickness);
    Add(fmt::format("wall {}", i), Make(WallOf(line, options)), Along(line), world);
  }
  for (std::size_t i = 0; i < doorways.size(); ++i) {
    const bool closed = LeadsOutside(doorways[i], plan.spaces);  // or the robot would drive away
    Add(fmt::format("doorway {}", i), Make(DoorwayOf(doorways[i], closed, options)), Along(doorways[i]),
        world);
  }
  for (PlacedThing& piece : FurnishPlan(plan, walls, options)) {
    Add(piece.name, std::move(piece.thing), ToPose3(piece.T_map_thing), world);
  }
  return world;
}

World ReadPlanWorld(const std::string& path, const PlanOptions& options) {
  std::error_code ignored;  // what cannot be asked for cannot be opened either
  if (std::filesystem::is_directory(path, ignored)) Fail("{}: is a folder, not a floor plan", path);
  std::ifstream in(path);
  if (!in) Fail("{}: cannot open the floor plan", path);
  std::stringstream text;
  text << in.rdbuf();
  if (in.bad()) Fail("{}: cannot read the floor plan", path);
  World world = ParsePlan(text.str(), path, options);
  if (world.name.empty()) world.name = std::filesystem::path(path).stem().string();
  return world;
}

}  // namespace ariadne::drivers
