#include "experiments/exploration/explore.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "planning/path/geodesic.h"

namespace ariadne::experiments {
namespace {

constexpr int kDiscCorners = 16;
constexpr double kWithin = 0.01;  // of what was planned as free, so that no disc reaches through a wall [m]

/// Where the robot stands is free, whether it has looked there or not.
planning::LabelledPolygon Disc(const Eigen::Vector2d& center, double radius) {
  planning::LabelledPolygon disc;
  for (int i = 0; i < kDiscCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDiscCorners;
    disc.outer.push_back({center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), false});
  }
  return disc;
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
    exploration.area.push_back(Disc(step.T_map_scan.translation, options.planner.robot_radius - kWithin));
    exploration.area.push_back(view.polygon);
    exploration.area = planning::LabelledUnion(exploration.area, options.united);
    if (exploration.steps.size() >= static_cast<std::size_t>(options.max_scans)) return exploration;
    const auto before = std::chrono::steady_clock::now();
    const planning::ViewPlan plan = planning::PlanNextView(
        exploration.area, step.T_map_scan, options.planner, seed + exploration.steps.size());
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
