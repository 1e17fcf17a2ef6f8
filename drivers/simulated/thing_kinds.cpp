#include "drivers/simulated/thing_kinds.h"

#include "drivers/simulated/building.h"
#include "drivers/simulated/fittings.h"
#include "drivers/simulated/furniture.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

template <typename Shape>
Thing MakeOf(YamlFields& fields, double) {
  Shape shape;
  fields.Read(shape);
  return Make(shape);
}

/// Pillars, cupboards and walls reach up to the ceiling unless they say otherwise.
template <typename Shape>
Thing MakeUpright(YamlFields& fields, double height) {
  Shape shape;
  shape.height = height;
  fields.Read(shape);
  return Make(shape);
}

Thing MakeWall(YamlFields& fields, double height) {
  const Eigen::Vector2d from = fields.Numbers("from", 2, 2, kPlace),
                        to = fields.Numbers("to", 2, 2, kPlace);
  Wall wall;
  wall.height = height;
  wall.length = (to - from).norm();
  if (!(wall.length > 0.0)) Fail("{}: the wall ends where it begins", fields.Where());
  fields.Read(wall);
  for (const YAML::Node& node : fields.List("openings")) {
    YamlFields opening(node, fields.file(), "an opening");
    wall.openings.emplace_back();
    opening.Read(wall.openings.back());
    opening.RequireAllTaken();
  }
  const double heading = std::atan2(to.y() - from.y(), to.x() - from.x());
  const slam::Pose3 T = ToPose3(slam::Pose2{heading, from});
  Thing thing = Make(wall);
  for (Part& part : thing) part.mesh = Moved(std::move(part.mesh), T);
  return thing;
}

/// A slab between two heights, over the rectangle `from`, `to` or the polygon `corners`.
TriangleMesh MakeSlab(YamlFields& fields, double bottom, double top) {
  std::vector<Eigen::Vector2d> outline;
  if (fields.Has("corners")) {
    for (const YAML::Node& node : fields.List("corners")) {
      outline.emplace_back(fields.ToNumbers(node, "corners", 2, 2, kPlace));
    }
  } else {
    const Eigen::Vector2d a = fields.Numbers("from", 2, 2, kPlace), b = fields.Numbers("to", 2, 2, kPlace);
    outline = {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
  }
  return MakePrism(outline, bottom, top);
}

struct Thickness {
  double thickness = 0.2;
  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("thickness", self.thickness, Unit("m"), Range{0.001, 10.0}, "of the slab");
  }
};

Thing MakeFloor(YamlFields& fields, double) {
  Thickness slab;
  fields.Read(slab);
  return {{"linoleum", MakeSlab(fields, -slab.thickness, 0.0)}};
}

Thing MakeCeiling(YamlFields& fields, double height) {
  Thickness slab;
  fields.Read(slab);
  const double bottom = fields.NumberOr(height, "height", {0.1, 1000.0});
  return {{"plaster", MakeSlab(fields, bottom, bottom + slab.thickness)}};
}

}  // namespace

const std::map<std::string, ThingMaker>& ThingKinds() {
  static const std::map<std::string, ThingMaker> kinds = {
      {"wall", MakeWall},
      {"floor", MakeFloor},
      {"ceiling", MakeCeiling},
      {"box", MakeOf<Block>},
      {"cylinder", MakeOf<Cylinder>},
      {"pillar", MakeUpright<Block>},
      {"column", MakeUpright<Cylinder>},
      {"table", MakeOf<Table>},
      {"chair", MakeOf<Chair>},
      {"shelf", MakeOf<Shelf>},
      {"radiator", MakeOf<Radiator>},
      {"garbage_can", MakeOf<GarbageCan>},
      {"plant", MakeOf<Plant>},
      {"person", MakeOf<Person>},
      {"staircase", MakeOf<Staircase>},
      {"railing", MakeOf<Railing>},
      {"elevator", MakeOf<Elevator>},
  };
  return kinds;
}

bool PlacesItself(const std::string& kind) {
  return kind == "wall" || kind == "floor" || kind == "ceiling";
}

const std::map<std::string, double>& CommonMaterials() {
  static const std::map<std::string, double> materials = {
      {"plaster", 0.8},  {"concrete", 0.4}, {"brick", 0.4},   {"stone", 0.45},     {"linoleum", 0.35},
      {"carpet", 0.3},   {"wood", 0.5},     {"door", 0.6},    {"door_frame", 0.4}, {"metal", 0.35},
      {"steel", 0.45},   {"enamel", 0.75},  {"ceramic", 0.4}, {"leaf", 0.5},       {"cloth", 0.25},
      {"shirt", 0.55},   {"skin", 0.6},     {"hair", 0.15},   {"rubber", 0.08},    {"paper", 0.7},
      {"plastic", 0.45}, {"glass", 0.05},   {"black", 0.06},
  };
  return materials;
}

}  // namespace ariadne::drivers
