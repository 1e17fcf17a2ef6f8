#include "experiments/studies/plan_output.h"

#include <fmt/format.h>

#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

struct Known {
  double area = 0.0, seen = 0.0, unseen = 0.0;
};

Known KnownOf(const PlanStep& step) {
  Known known;
  for (const planning::LabelledPolygon& polygon : step.area) {
    known.area += slam::Area(planning::ToPolygon2(polygon));
    known.seen += planning::SeenLength(polygon);
    known.unseen += planning::UnseenLength(polygon);
  }
  return known;
}

Json PoseOf(const Eigen::Vector2d& p_map, double angle) {
  return {{"x", p_map.x()}, {"y", p_map.y()}, {"angle", angle}};
}

}  // namespace

Json ToJson(const PlanStep& step) {
  const Known known = KnownOf(step);
  Json json{{"status", NameOf(step.plan.status)}};
  if (step.plan.chosen) {
    const planning::View& view = step.plan.views[*step.plan.chosen];
    json["pose_map"] = PoseOf(view.p_map, view.direction);
    json["gain_rays"] = view.gain;
    json["gain_m2"] = view.area;
    json["shown"] = view.shown;
    json["overlap"] = view.overlap;
    json["distance_m"] = view.distance;
    json["turn_rad"] = view.turn;
    for (const Eigen::Vector2d& p : step.plan.path_map) json["path_map"].push_back({p.x(), p.y()});
  }
  json["robot_map"] = PoseOf(step.T_map_robot.translation, step.T_map_robot.angle);
  json["slice_z"] = step.slice_z;
  json["scans"] = step.slices.size();
  json["candidates"] = step.plan.views.size();
  json["area_m2"] = known.area;
  json["seen_m"] = known.seen;
  json["unseen_m"] = known.unseen;
  return json;
}

std::string ToText(const PlanStep& step) {
  const Known known = KnownOf(step);
  std::string text = fmt::format("known:     {:.1f} m^2, {:.1f} m of walls, {:.1f} m unseen\n", known.area,
                                 known.seen, known.unseen);
  if (!step.plan.chosen) {
    return text + (step.plan.status == planning::NextViewStatus::kNoGain
                       ? "next view: none, nothing more is to be seen\n"
                       : "next view: none, there is no place that the robot can reach\n");
  }
  const planning::View& view = step.plan.views[*step.plan.chosen];
  return text + fmt::format(
                    "next view: ({:.2f}, {:.2f}) m, {:.0f} deg\n"
                    "gain:      {} rays, {:.1f} m^2\n"
                    "distance:  {:.2f} m, turn {:.0f} deg\n",
                    view.p_map.x(), view.p_map.y(), slam::DegFromRad(view.direction), view.gain, view.area,
                    view.distance, slam::DegFromRad(view.turn));
}

}  // namespace ariadne::experiments
