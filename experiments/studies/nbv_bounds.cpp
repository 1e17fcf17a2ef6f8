#include "experiments/studies/nbv_bounds.h"

#include <filesystem>
#include <fstream>

#include "experiments/config/options_io.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// What a floor is told by, apart from its name.
Json MarksOf(const NbvFloor& floor) {
  return {floor.floor.faces.size(), floor.cover.places_map.size(), floor.reachable.size()};
}

Json JsonOfBound(const NbvFloor& floor, const FloorBound& bound) {
  Json json{{"marks", MarksOf(floor)},
            {"lower_bound", bound.lower_bound},
            {"covered", bound.covered},
            {"views", Json::array()}};
  for (const slam::Pose2& view : bound.views) {
    json["views"].push_back({view.translation.x(), view.translation.y(), view.angle});
  }
  return json;
}

FloorBound BoundOfJson(const Json& json, const NbvFloor& floor, double robot_radius) {
  FloorBound bound;
  bound.lower_bound = json.at("lower_bound");
  bound.covered = json.at("covered");
  for (const Json& view : json.at("views")) {
    bound.views.push_back({view.at(2).get<double>(), {view.at(0).get<double>(), view.at(1).get<double>()}});
  }
  bound.ways_to = WaysBetween(bound.views, floor.free, robot_radius);
  return bound;
}

}  // namespace

NbvBounds::NbvBounds(const NbvFloorOptions& options, const FloorScannerOptions& scanner)
    : options_(options), scanner_(scanner) {
  json_["options"] = WriteOptions(options) + WriteOptions(scanner);
  json_["floors"] = Json::object();
}

void NbvBounds::Read(const std::string& run_directory) {
  const std::filesystem::path file = std::filesystem::path(run_directory) / "bounds.json";
  std::ifstream in(file);
  const Json json = Json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("options") || !json.contains("floors")) {
    Fail("{} holds no bounds; name the directory of a run of ablation_nbv", file.string());
  }
  if (json["options"] != json_["options"]) {
    Fail("{} was searched with other options of floor, share or explore.scanner; leave bounds_of empty",
         file.string());
  }
  known_ = json["floors"];
}

const FloorBound& NbvBounds::Of(const NbvFloor& floor, const Parallel& parallel) {
  const auto found = known_.find(floor.floor.name);
  if (found != known_.end() && found->at("marks") == MarksOf(floor)) {
    bound_ = BoundOfJson(*found, floor, options_.bound.robot_radius);
  } else {
    bound_ = FindFloorBound(floor.floor, floor.reachable, floor.cover, floor.free, scanner_, options_.bound,
                            parallel);
  }
  json_["floors"][floor.floor.name] = JsonOfBound(floor, bound_);
  return bound_;
}

}  // namespace ariadne::experiments
