#include "drivers/simulated/world_reader.h"

#include <utility>

#include "drivers/simulated/thing_kinds.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::drivers {
namespace {

constexpr Range kAngle{-360.0, 360.0};              // [deg]
constexpr std::size_t kMostTriangles = 20'000'000;  // 1 GB; groups of groups grow quickly
constexpr int kMostThings = 1'000'000;
constexpr int kMostDepth = 8;

template <typename Map>
std::vector<std::string> NamesOf(const Map& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

slam::Pose3 Upright(const Eigen::Vector3d& place, double heading_deg) {
  const Eigen::AngleAxisd turn(slam::RadFromDeg(heading_deg), Eigen::Vector3d::UnitZ());
  return {Eigen::Quaterniond(turn), place};
}

}  // namespace

World WorldReader::Read(const YAML::Node& root) {
  YamlFields fields(root, file_, "a world");
  world_.name = fields.TextOr("", "name");
  const Eigen::Vector3d start = fields.Numbers("start", 3, 3, kPlace);
  world_.T_map_start = {slam::WrapAngle(slam::RadFromDeg(start.z())), start.head<2>()};
  height_ = fields.NumberOr(height_, "height", {0.1, 1000.0});
  ReadMaterials(fields);
  for (const auto& [name, node] : fields.Entries("groups")) {
    if (!node.IsSequence()) Fail("{}: the group {} is a list of things", fields.WhereIs(node), name);
    groups_[name] = {node.begin(), node.end()};
  }
  ReadThings(fields.List("things"), {});
  fields.RequireAllTaken();
  return std::move(world_);
}

void WorldReader::ReadMaterials(YamlFields& fields) {
  materials_ = CommonMaterials();
  for (const auto& [name, node] : fields.Entries("materials")) {
    materials_[name] = fields.ToNumber(node, name, {0.0, 1.0});
  }
}

void WorldReader::ReadThings(const std::vector<YAML::Node>& things, const Place& place) {
  for (const YAML::Node& node : things) {
    if (++things_ > kMostThings) Fail("{}: the world has more than {} things", file_, kMostThings);
    const YamlFields outer(node, file_, "a thing");
    if (node.size() != 1)
      Fail("{}: a thing is one kind with its keys, as in `- table: {{at: [1, 2]}}`", outer.Where());
    const std::string kind = node.begin()->first.Scalar();
    const YAML::Node keys = node.begin()->second;
    if (kind != "group" && !ThingKinds().contains(kind)) {
      std::vector<std::string> kinds = NamesOf(ThingKinds());
      kinds.emplace_back("group");
      Fail("{}: unknown kind {}; did you mean {}?", outer.Where(), kind, NearestName(kind, kinds));
    }
    YamlFields fields(keys, file_, kind);
    kind == "group" ? ReadGroup(fields, place) : ReadThing(kind, fields, place);
    fields.RequireAllTaken();
  }
}

void WorldReader::ReadGroup(YamlFields& fields, const Place& place) {
  const std::string name = fields.Text("of");
  const auto group = groups_.find(name);
  if (group == groups_.end()) {
    Fail("{}: unknown group {}; did you mean {}?", fields.Where(), name,
         NearestName(name, NamesOf(groups_)));
  }
  if (place.depth == kMostDepth)
    Fail("{}: the group {} is nested too deeply, or in itself", fields.Where(), name);
  ReadThings(group->second, {place.T_map_list * ReadPose(fields), place.depth + 1});
}

slam::Pose3 WorldReader::ReadPose(YamlFields& fields) const {
  const Eigen::Vector2d at = fields.Numbers("at", 2, 2, kPlace);
  const double z = fields.NumberOr(0.0, "z", kPlace);
  return Upright({at.x(), at.y(), z}, fields.NumberOr(0.0, "turn", kAngle));
}

Motion WorldReader::ReadPath(YamlFields& fields) const {
  Motion motion;
  const double z = fields.NumberOr(0.0, "z", kPlace);
  for (const YAML::Node& node : fields.List("path")) {
    const Eigen::VectorXd k = fields.ToNumbers(node, "path", 4, 4, kPlace);
    motion.times.push_back(k[0]);
    motion.T_map_body.push_back(Upright({k[1], k[2], z}, k[3]));
  }
  if (motion.times.size() < 2)
    Fail("{}: a path needs two places, as in [[0, x, y, heading], [5, x, y, heading]]", fields.Where());
  RequireSound(motion, fields.Where());
  return motion;
}

void WorldReader::ReadThing(const std::string& kind, YamlFields& fields, const Place& place) {
  const std::string name = fields.TextOr(fmt::format("{} {}", kind, ++counts_[kind]), "name");
  const bool moves = fields.Has("path");
  if (moves && (place.depth > 0 || PlacesItself(kind)))
    Fail("{}: {} cannot have a path here", fields.Where(), kind);
  const Motion motion = moves ? ReadPath(fields) : Motion{};
  slam::Pose3 T_map_thing = moves ? slam::Pose3{} : place.T_map_list;
  if (PlacesItself(kind)) {
    const double z = fields.NumberOr(0.0, "z", kPlace);
    T_map_thing = T_map_thing * Upright({0.0, 0.0, z}, 0.0);
  } else if (!moves) {
    T_map_thing = T_map_thing * ReadPose(fields);
  }
  Thing thing;
  try {
    thing = ThingKinds().at(kind)(fields, height_);
  } catch (const Error& e) {
    const std::string sentence = e.what();
    if (sentence.starts_with(file_)) throw;
    Fail("{}: {}", fields.Where(), sentence);
  }
  thing.front().material = fields.TextOr(thing.front().material, "material");
  for (Part& part : thing) part.mesh = Moved(std::move(part.mesh), T_map_thing);
  AddBodies(name, std::move(thing), motion, fields);
}

void WorldReader::AddBodies(const std::string& name, Thing thing, const Motion& motion,
                            const YamlFields& fields) {
  for (Part& part : thing) {
    if (part.mesh.triangles.empty()) continue;
    triangles_ += part.mesh.triangles.size();
    if (triangles_ > kMostTriangles)
      Fail("{}: the world has more than {} triangles", fields.Where(), kMostTriangles);
    const double reflectance = ReflectanceOf(part.material, fields);
    world_.bodies.push_back(
        {fmt::format("{}/{}", name, part.material), std::move(part.mesh), {reflectance}, motion});
  }
}

double WorldReader::ReflectanceOf(const std::string& material, const YamlFields& fields) const {
  const auto found = materials_.find(material);
  if (found != materials_.end()) return found->second;
  Fail("{}: unknown material {}; did you mean {}?", fields.Where(), material,
       NearestName(material, NamesOf(materials_)));
}

}  // namespace ariadne::drivers
