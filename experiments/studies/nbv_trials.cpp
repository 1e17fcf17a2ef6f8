#include "experiments/studies/nbv_trials.h"

#include <numbers>

#include "drivers/simulated/load_world.h"
#include "experiments/run/data_path.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

constexpr double kFreeSpacing = 2.0;  // between places that together see all free space [m]

slam::Pose2 StartOn(const NbvFloor& floor, std::uint64_t seed) {
  if (seed == 1) return floor.floor.T_map_start;
  RandomStream stream = NamedStream(seed, "nbv/start");
  const Eigen::Vector2d& place = floor.reachable[stream() % floor.reachable.size()];
  return {DrawUniform(stream, -std::numbers::pi, std::numbers::pi), place};
}

}  // namespace

NbvFloor PrepareFloor(const std::string& world, const NbvFloorOptions& options,
                      const FloorScannerOptions& scanner, const Parallel& parallel) {
  Floor cut = CutFloor(drivers::LoadWorld(ExpandDataPath(world).string()), options.height);
  std::vector<Eigen::Vector2d> reachable = ReachableFloor(cut, options.cover);
  FloorCover cover = FindFloorCover(cut, reachable, scanner, options.cover, parallel);
  planning::FreeSpace free = FreeFloor(cut, reachable, scanner, kFreeSpacing);
  return {std::move(cut), std::move(reachable), std::move(cover), std::move(free), {}};
}

NbvTrial TryNbv(const NbvFloor& floor, const NbvVariant& variant, double share, std::uint64_t seed) {
  const slam::Pose2 T_map_start = StartOn(floor, seed);
  const Exploration exploration = Explore(floor.floor, floor.cover, T_map_start, variant.explore, seed);
  NbvTrial trial{floor.floor.name,
                 variant.study,
                 variant.name,
                 seed,
                 0.0,
                 0.0,
                 0.0,
                 0.0,
                 0.0,
                 false,
                 0.0,
                 0.0,
                 {},
                 {},
                 {}};
  trial.scans = static_cast<double>(exploration.steps.size());
  trial.path = exploration.steps.back().path;
  trial.scans_95 = ScansTo(exploration, share);
  trial.path_95 = PathTo(exploration, share);
  trial.covered = exploration.steps.back().covered;
  trial.ended = exploration.ended;
  for (const ExploreStep& step : exploration.steps) {
    trial.covered_after.push_back(step.covered);
    trial.path_after.push_back(step.path);
    if (step.planning_seconds > 0.0) trial.planning_seconds.push_back(step.planning_seconds);
  }
  if (floor.bound.views.empty()) return trial;
  trial.bound_scans = floor.bound.lower_bound;
  trial.bound_path =
      TourLength(floor.bound, T_map_start.translation, floor.free, variant.explore.planner.robot_radius);
  return trial;
}

}  // namespace ariadne::experiments
