#include "experiments/exploration/explore.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "control/simulate_approach.h"
#include "planning/path/geodesic.h"

namespace ariadne::experiments {
namespace {

constexpr int kDiscCorners = 16;
constexpr double kWithin = 0.01;  // of what was planned as free, so that no disc reaches through a wall [m]

/// What the controller makes of a way: from corner to corner, each reached in the direction of the next.
planning::WayCost CostByController(const slam::Pose2& T_map_robot, ExploreWay way) {
  if (way == ExploreWay::kPlanner) return {};
  return [T_map_robot, way](std::span<const Eigen::Vector2d> path_map, const planning::View& view) {
    const control::ApproachOptions options;
    slam::Pose2 at = T_map_robot;
    double cost = 0.0;
    for (std::size_t i = 1; i < path_map.size(); ++i) {
      double angle = view.direction;
      if (i + 1 < path_map.size()) {
        const Eigen::Vector2d ahead = path_map[i + 1] - path_map[i];
        angle = std::atan2(ahead.y(), ahead.x());
      }
      const slam::Pose2 goal{angle, path_map[i]};
      if ((goal.translation - at.translation).norm() < options.goal_distance) continue;
      const control::ApproachCostResult leg = control::ApproachCost(at, goal, options);
      const double metres_per_second = options.limits.max_speed;
      cost += way == ExploreWay::kControllerTime ? metres_per_second * leg.duration : leg.length;
      at = goal;
    }
    return cost;
  };
}

/// What has been seen so far of the cover.
class Covered {
 public:
  explicit Covered(const FloorCover& cover) : cover_(cover), seen_(cover.places_map.size(), false) {}

  double Add(const FloorView& view, const FloorScannerOptions& scanner) {
    for (const std::uint32_t k : SeenPlaces(view, cover_, scanner)) {
      count_ += seen_[k] ? 0 : 1;
      seen_[k] = true;
    }
    return static_cast<double>(count_) / static_cast<double>(seen_.size());
  }

 private:
  const FloorCover& cover_;
  std::vector<bool> seen_;
  std::size_t count_ = 0;
};

double Seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

std::vector<slam::Pose2> ScansOf(const Exploration& exploration) {
  std::vector<slam::Pose2> T_map_scans;
  for (const ExploreStep& step : exploration.steps) T_map_scans.push_back(step.T_map_scan);
  return T_map_scans;
}

/// The first step by which a share is covered.
const ExploreStep* StepOf(const Exploration& exploration, double share) {
  const auto found = std::ranges::find_if(exploration.steps,
                                          [&](const ExploreStep& step) { return step.covered >= share; });
  return found == exploration.steps.end() ? nullptr : &*found;
}

}  // namespace

Exploration Explore(const Floor& floor, const FloorCover& cover, const slam::Pose2& T_map_start,
                    const ExploreOptions& options, std::uint64_t seed) {
  Exploration exploration;
  Covered covered(cover);
  ExploreStep step{T_map_start, 0.0, 0.0, 0, 0.0};
  for (;;) {
    const FloorView view = ViewFloor(floor, step.T_map_scan, options.scanner);
    step.covered = covered.Add(view, options.scanner);
    exploration.steps.push_back(step);
    exploration.area.push_back(planning::UnseenDisc(step.T_map_scan.translation,
                                                    options.planner.robot_radius - kWithin, kDiscCorners));
    exploration.area.push_back(view.polygon);
    exploration.area = planning::LabelledUnion(exploration.area, options.united);
    if (exploration.steps.size() >= static_cast<std::size_t>(options.max_scans)) return exploration;
    const auto before = std::chrono::steady_clock::now();
    const planning::ViewPlan plan = planning::PlanNextView(
        exploration.area, step.T_map_scan, options.planner, seed + exploration.steps.size(),
        ScansOf(exploration), CostByController(step.T_map_scan, options.way));
    step.planning_seconds = Seconds(before);
    exploration.ended = !plan.chosen;
    if (!plan.chosen) return exploration;
    const planning::View& chosen = plan.views[*plan.chosen];
    step.T_map_scan = {chosen.direction, chosen.p_map};
    step.path += planning::LengthOf(plan.path_map);
    step.gain = chosen.gain;
  }
}

double ScansTo(const Exploration& exploration, double share) {
  const ExploreStep* step = StepOf(exploration, share);
  return step == nullptr ? std::numeric_limits<double>::infinity()
                         : static_cast<double>(step - exploration.steps.data() + 1);
}

double PathTo(const Exploration& exploration, double share) {
  const ExploreStep* step = StepOf(exploration, share);
  return step == nullptr ? std::numeric_limits<double>::infinity() : step->path;
}

}  // namespace ariadne::experiments
