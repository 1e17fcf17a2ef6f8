#include "planning/view/next_view.h"

#include <cmath>

#include "planning/view/best_of.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
double GainOf(const View& view, const NextViewOptions& options) {
  return options.gain.measure == GainMeasure::kArea ? view.area : view.gain;
}

double LogValue(const View& view, const NextViewOptions& options) {
  return std::log(GainOf(view, options)) + options.rest_weight * std::log(view.shown) -
         options.distance_weight * view.distance - options.angle_weight * slam::DegFromRad(view.turn);
}

View JudgedView(const Eigen::Vector2d& p_map, const ViewGain& best, double way,
                const slam::Pose2& T_map_robot, const NextViewOptions& options) {
  View view{p_map, best.direction, best.gain, best.area, best.shown, best.overlap, way, 0.0, 0.0};
  view.turn = std::abs(slam::WrapAngle(best.direction - T_map_robot.angle));
  view.value = std::exp(LogValue(view, options));  // of no gain: exp(-inf) = 0
  return view;
}

NextViewOptions PaperNextViewOptions() {
  NextViewOptions options;
  options.gain.measure = GainMeasure::kRays;
  options.angle_weight = 0.01;
  options.distance_weight = 5.0;  // 0.05 per cm
  options.rest_weight = 0.0;
  options.min_gain = 1;
  return options;
}

NextViewResult ChooseNextView(std::span<const Eigen::Vector2d> candidates, std::span<const Edge> edges,
                              const slam::Pose2& T_map_robot, const NextViewOptions& options) {
  CheckOptions(options, "view.");
  RequirePlaces(std::span(&T_map_robot.translation, 1), "robot");
  const RayGain gain(edges, T_map_robot.angle, options.gain);
  NextViewResult result;
  std::vector<std::size_t> worth;
  for (const Eigen::Vector2d& p_map : candidates) {
    const double way = (p_map - T_map_robot.translation).norm();
    result.views.push_back(JudgedView(p_map, gain.At(p_map), way, T_map_robot, options));
    if (result.views.back().gain >= options.min_gain) worth.push_back(result.views.size() - 1);
  }
  if (candidates.empty()) return result;
  result.status = worth.empty() ? NextViewStatus::kNoGain : NextViewStatus::kFound;
  if (worth.empty()) return result;
  result.chosen = BestOf(worth, [&](std::size_t i) { return LogValue(result.views[i], options); });
  return result;
}

}  // namespace ariadne::planning
