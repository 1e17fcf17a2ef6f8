#include "experiments/studies/explore_steps.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kDrivenStep = 0.05;  // between places of the way that are kept [m]

double Rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json PlaceJson(const Eigen::Vector2d& p) { return {Rounded(p.x()), Rounded(p.y())}; }

Eigen::Vector2d PlaceOf(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

Json PoseJson(const Pose2& pose) {
  return {Rounded(pose.translation.x()), Rounded(pose.translation.y()), Rounded(pose.angle)};
}

Pose2 PoseOf(const Json& json) { return {json.at(2).get<double>(), PlaceOf(json)}; }

/// A corner with a 1 where the edge from it is seen.
Json RingJson(const planning::LabelledRing& ring) {
  Json corners = Json::array();
  for (const planning::LabelledCorner& corner : ring)
    corners.push_back({Rounded(corner.p_map.x()), Rounded(corner.p_map.y()), corner.seen ? 1 : 0});
  return corners;
}

planning::LabelledRing RingOf(const Json& json) {
  planning::LabelledRing ring;
  for (const Json& corner : json) ring.push_back({PlaceOf(corner), corner.at(2).get<int>() == 1});
  return ring;
}

Json AreaJson(const std::vector<planning::LabelledPolygon>& area) {
  Json polygons = Json::array();
  for (const planning::LabelledPolygon& polygon : area) {
    Json holes = Json::array();
    for (const planning::LabelledRing& hole : polygon.holes) holes.push_back(RingJson(hole));
    polygons.push_back({{"outer", RingJson(polygon.outer)}, {"holes", std::move(holes)}});
  }
  return polygons;
}

Json ViewJson(const planning::View& view) {
  return {{"place", PlaceJson(view.p_map)}, {"direction", Rounded(view.direction)}, {"rays", view.gain},
          {"area_m2", Rounded(view.area)},  {"way_m", Rounded(view.distance)},      {"value", view.value}};
}

planning::View ViewOf(const Json& json) {
  planning::View view;
  view.p_map = PlaceOf(json.at("place"));
  view.direction = json.at("direction").get<double>();
  view.gain = json.at("rays").get<int>();
  view.area = json.at("area_m2").get<double>();
  view.distance = json.at("way_m").is_null() ? INFINITY : json.at("way_m").get<double>();
  view.value = json.at("value").get<double>();
  return view;
}

}  // namespace

const ExploredStep& MissionSteps::OnStop(const MissionStop& stop, const MissionMap& map) {
  step_ = {};
  step_.index = map.size() - 1;
  step_.registered = stop.registered;
  for (std::size_t i = 0; i < map.size(); ++i) step_.T_map_stops.push_back(map.T_map_base(i));
  for (const Pose2& pose : stop.driven_map) {
    if (!driven_map_.empty() && (pose.translation - driven_map_.back()).norm() < kDrivenStep) continue;
    step_.driven_map.push_back(pose.translation);
    driven_map_.push_back(pose.translation);
  }
  step_.area = map.Area(0);
  return step_;
}

const ExploredStep& MissionSteps::OnPlan(const PlannedDrive& drive, const Surroundings& around) {
  step_.view = drive.view;
  step_.planned_map = drive.path_map;
  step_.leg_only = drive.leg_only;
  step_.of_disc = drive.of_disc;
  step_.obstacles_map = around.obstacles_map;
  return step_;
}

const ExploredStep& MissionSteps::OnEnd(const MissionResult& result) {
  step_.view.reset();
  step_.planned_map.clear();
  step_.area = result.area;
  step_.obstacles_map = result.obstacles_map;
  return step_;
}

std::string StepName(std::size_t index) { return fmt::format("steps/step{:03}", index); }

Json ToJson(const ExploredStep& step) {
  Json stops = Json::array(), driven = Json::array(), planned = Json::array();
  for (const Pose2& pose : step.T_map_stops) stops.push_back(PoseJson(pose));
  for (const Eigen::Vector2d& p : step.driven_map) driven.push_back(PlaceJson(p));
  for (const Pose2& pose : step.planned_map) planned.push_back(PoseJson(pose));
  return {{"scan", step.index},
          {"registered", step.registered},
          {"stops_m_rad", std::move(stops)},
          {"driven_m", std::move(driven)},
          {"next_view", step.view ? ViewJson(*step.view) : Json()},
          {"planned_m_rad", std::move(planned)},
          {"leg_only", step.leg_only},
          {"of_disc", step.of_disc},
          {"area_m_seen", AreaJson(step.area)}};
}

ExploredStep StepFromJson(const Json& json, const std::string& name) {
  ExploredStep step;
  try {
    step.index = json.at("scan").get<std::size_t>();
    step.registered = json.at("registered").get<bool>();
    for (const Json& pose : json.at("stops_m_rad")) step.T_map_stops.push_back(PoseOf(pose));
    for (const Json& p : json.at("driven_m")) step.driven_map.push_back(PlaceOf(p));
    if (!json.at("next_view").is_null()) step.view = ViewOf(json.at("next_view"));
    for (const Json& pose : json.at("planned_m_rad")) step.planned_map.push_back(PoseOf(pose));
    step.leg_only = json.at("leg_only").get<bool>();
    step.of_disc = json.at("of_disc").get<bool>();
    for (const Json& polygon : json.at("area_m_seen")) {
      planning::LabelledPolygon& labelled = step.area.emplace_back();
      labelled.outer = RingOf(polygon.at("outer"));
      for (const Json& hole : polygon.at("holes")) labelled.holes.push_back(RingOf(hole));
    }
  } catch (const Json::exception&) {
    Fail("{}: this is not a step of a mission", name);
  }
  if (step.T_map_stops.size() != step.index + 1)
    Fail("{}: scan {} with {} stops", name, step.index, step.T_map_stops.size());
  return step;
}

std::vector<ExploredStep> ReadSteps(const std::filesystem::path& run) {
  std::vector<ExploredStep> steps;
  for (;;) {
    const std::filesystem::path file = run / (StepName(steps.size()) + ".json");
    if (!std::filesystem::exists(file)) break;
    std::ifstream in = slam::OpenForReading(file);
    steps.push_back(StepFromJson(Json::parse(in, nullptr, false), file.string()));
  }
  if (steps.empty()) Fail("{}: holds no steps; give the directory of a run of `explore`", run.string());
  return steps;
}

}  // namespace ariadne::experiments
