#include "planning/view/next_view.h"

#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

View Judge(const Eigen::Vector2d& p_map, const RayGain& gain, const slam::Pose2& T_map_robot,
           const NextViewOptions& options) {
  const ViewGain best = gain.At(p_map);
  View view;
  view.p_map = p_map;
  view.direction = best.direction;
  view.gain = best.gain;
  view.area = best.area;
  view.overlap = best.overlap;
  view.distance = (p_map - T_map_robot.translation).norm();
  view.turn = std::abs(slam::WrapAngle(best.direction - T_map_robot.angle));
  view.value = std::exp(LogValue(view, options));  // of no gain: exp(-inf) = 0
  return view;
}

}  // namespace

double LogValue(const View& view, const NextViewOptions& options) {
  const double gain = options.gain.measure == GainMeasure::kArea ? view.area : view.gain;
  return std::log(gain) - options.distance_weight * view.distance -
         options.angle_weight * slam::DegFromRad(view.turn);
}

NextViewOptions PaperNextViewOptions() {
  NextViewOptions options;
  options.gain.measure = GainMeasure::kRays;
  options.angle_weight = 0.01;
  options.distance_weight = 5.0;  // 0.05 per cm
  options.min_gain = 1;
  return options;
}

NextViewResult ChooseNextView(std::span<const Eigen::Vector2d> candidates, std::span<const Edge> edges,
                              const slam::Pose2& T_map_robot, const NextViewOptions& options) {
  CheckOptions(options, "view.");
  RequirePlaces(std::span(&T_map_robot.translation, 1), "robot");
  const RayGain gain(edges, T_map_robot.angle, options.gain);
  NextViewResult result;
  double highest = 0.0;
  for (const Eigen::Vector2d& p_map : candidates) {
    const View view = result.views.emplace_back(Judge(p_map, gain, T_map_robot, options));
    if (view.gain < options.min_gain) continue;
    const double log_value = LogValue(view, options);
    if (result.chosen && log_value <= highest) continue;
    highest = log_value;
    result.chosen = result.views.size() - 1;
  }
  if (!candidates.empty()) result.status = result.chosen ? NextViewStatus::kFound : NextViewStatus::kNoGain;
  return result;
}

}  // namespace ariadne::planning
