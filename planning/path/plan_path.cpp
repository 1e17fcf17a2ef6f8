#include "planning/path/plan_path.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "planning/path/forward_way.h"
#include "planning/path/geodesic.h"
#include "planning/path/motion_model.h"
#include "planning/path/ompl_support.h"
#include "planning/path/path_guides.h"
#include "planning/path/plane_neighbors.h"
#include "planning/path/pose_raster.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kSamePlace = 1e-3;                             // [m]
constexpr double kSameAngle = 0.1 * std::numbers::pi / 180.0;   // [rad]
constexpr double kGuideSpread = 0.3;                            // [m]
constexpr double kGuideTurn = 20.0 * std::numbers::pi / 180.0;  // [rad]
constexpr int kLegIterations = 300;
constexpr std::size_t kMostRasterPoses = 5000000;  // of a search that finds no way
constexpr std::size_t kMostForwardPoses = 1000000;
constexpr double kAroundLeg = 3.0, kInSight = 20.0;  // [m]
constexpr double kShortLeg = 3.0, kLongLeg = 7.0;    // between stops on the way of a disc [m]
constexpr double kShortStep = 0.3, kLongStep = 0.8;  // and on that of poses [m]

class PoseSampler : public ob::StateSampler {
 public:
  PoseSampler(const ob::StateSpace* space, RandomStream stream, const internal::PathSamples& samples,
              double guided)
      : ob::StateSampler(space),
        stream_(stream),
        samples_(samples),
        guided_(samples.guides.empty() ? 0.0 : guided) {}

  void sampleUniform(ob::State* state) override {
    if (samples_.cells.empty() || DrawUniform(stream_, 0.0, 1.0) < guided_) return SampleGuide(state);
    const Eigen::Vector2d& cell = Any(samples_.cells);
    const double half = 0.5 * samples_.cell, x = DrawUniform(stream_, -half, half),
                 y = DrawUniform(stream_, -half, half);
    internal::SetState(
        {DrawUniform(stream_, -std::numbers::pi, std::numbers::pi), cell + Eigen::Vector2d(x, y)}, state);
    space_->enforceBounds(state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const slam::Pose2 middle = internal::PoseOf(near);
    const auto draw = [&] { return DrawUniform(stream_, -distance, distance); };
    const double x = draw(), y = draw();
    internal::SetState({middle.angle + draw(), middle.translation + Eigen::Vector2d(x, y)}, state);
    space_->enforceBounds(state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double std_dev) override {
    Scatter(internal::PoseOf(mean), std_dev, std_dev, state);
  }

 private:
  template <typename T>
  const T& Any(const std::vector<T>& values) {
    const double at = DrawUniform(stream_, 0.0, static_cast<double>(values.size()));
    return values[std::min(static_cast<std::size_t>(at), values.size() - 1)];
  }
  void SampleGuide(ob::State* state) {
    if (samples_.guides.empty()) Fail("there is no place to sample a path from");
    // Of all sizes: doors need what is nearly exact.
    const double share = std::pow(DrawUniform(stream_, 0.0, 1.0), 3.0);
    Scatter(Any(samples_.guides), share * kGuideSpread, share * kGuideTurn, state);
  }
  void Scatter(const slam::Pose2& mean, double spread, double turn, ob::State* state) {
    const double x = DrawNormal(stream_, 0.0, spread), y = DrawNormal(stream_, 0.0, spread);
    internal::SetState(
        {mean.angle + DrawNormal(stream_, 0.0, turn), mean.translation + Eigen::Vector2d(x, y)}, state);
    space_->enforceBounds(state);
  }

  RandomStream stream_;
  const internal::PathSamples& samples_;
  double guided_;
};

/// OMPL seeds generators by how many there have been; these are seeded by us.
class SeededRrtConnect : public og::RRTConnect {
 public:
  SeededRrtConnect(const ob::SpaceInformationPtr& info, std::uint64_t seed) : og::RRTConnect(info) {
    rng_.setLocalSeed(internal::OmplSeed(seed, "path/rrt_connect"));
  }
};
class SeededSimplifier : public og::PathSimplifier {
 public:
  SeededSimplifier(const ob::SpaceInformationPtr& info, std::uint64_t seed) : og::PathSimplifier(info) {
    rng_.setLocalSeed(internal::OmplSeed(seed, "path/simplifier"));
  }
};

class PathPlanner {
 public:
  PathPlanner(const FreeSpace& space, const PathOptions& options, std::uint64_t seed)
      : space_(space),
        options_(options),
        seed_(seed),
        footprint_(options.footprint),
        model_(space, options) {}

  PathResult Plan(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal) {
    PathResult result;
    if (!footprint_.IsFree(space_, T_map_start)) return result.status = PathStatus::kStartNotFree, result;
    if (!footprint_.IsFree(space_, T_map_goal)) return result.status = PathStatus::kGoalNotFree, result;
    if (IsSame(T_map_start, T_map_goal)) return Dense({T_map_start, T_map_goal}, result);
    const Eigen::Vector2d start_map = footprint_.CentreAt(T_map_start);
    // Every place on a way of the robot is within 1.5 cells of a cell that is free for this radius.
    const double radius = std::max(0.0, footprint_.least_radius() - 1.5 * space_.resolution());
    const GeodesicField reachable = DistancesFrom(space_, start_map, radius);
    if (std::isinf(reachable.To(footprint_.CentreAt(T_map_goal)))) {
      return result.status = PathStatus::kUnreachable, result;
    }
    const std::vector<slam::Pose2> guides =
        internal::FindGuides(space_, footprint_, reachable, T_map_start, T_map_goal);
    std::vector<slam::Pose2> corners = GrowLegs(reachable, T_map_start, T_map_goal, guides,
                                                internal::StopsAmong(space_, guides, kShortLeg, kLongLeg),
                                                options_.max_iterations / 2, result.iterations);
    if (corners.empty()) corners = GrowOnRaster(reachable, T_map_start, T_map_goal, result.iterations);
    if (corners.empty()) {
      samples_ = internal::SamplesOf(space_, reachable, guides, std::numeric_limits<double>::infinity());
      corners =
          Grow(T_map_start, T_map_goal, options_.max_iterations - result.iterations, result.iterations);
    }
    if (corners.empty() && options_.model == PathModel::kDubins)
      corners = SearchForward(radius, T_map_start, T_map_goal);
    if (corners.empty()) return result;
    return Dense(Simplified(corners), result);
  }

 private:
  static bool IsSame(const slam::Pose2& a, const slam::Pose2& b) {
    return (a.translation - b.translation).norm() <= kSamePlace &&
           std::abs(slam::WrapAngle(a.angle - b.angle)) <= kSameAngle;
  }

  ob::SpaceInformationPtr MakeInformation() {
    const auto& state_space = model_.state_space();
    state_space->setStateSamplerAllocator(
        [this, made = std::make_shared<int>(0)](const ob::StateSpace* of) {
          return std::make_shared<PoseSampler>(
              of, NamedStream(seed_, fmt::format("path/sampler/{}", (*made)++)), samples_, options_.guided);
        });
    auto info = std::make_shared<ob::SpaceInformation>(state_space);
    info->setStateValidityChecker(
        [this](const ob::State* state) { return footprint_.IsFree(space_, internal::PoseOf(state)); });
    info->setMotionValidator(
        std::make_shared<internal::RectangleMotions>(info, space_, footprint_, model_));
    info->setup();
    return info;
  }

  /// From stop to stop among the guides, one every few metres: two trees find each other in a room, hardly
  /// through ten.
  std::vector<slam::Pose2> GrowLegs(const GeodesicField& reachable, const slam::Pose2& T_map_start,
                                    const slam::Pose2& T_map_goal, const std::vector<slam::Pose2>& guides,
                                    const std::vector<std::size_t>& stops, int up_to, int& iterations) {
    std::vector<slam::Pose2> corners{T_map_start};
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= stops.size(); ++i) {
      const bool is_last = i == stops.size();
      const std::size_t end = is_last ? guides.size() : stops[i] + 1;
      const std::vector<slam::Pose2> near(guides.begin() + static_cast<std::ptrdiff_t>(begin),
                                          guides.begin() + static_cast<std::ptrdiff_t>(end));
      samples_ = internal::SamplesOf(space_, reachable, near, kAroundLeg);
      const int most = std::min(kLegIterations, up_to - iterations);
      const auto leg = Grow(corners.back(), is_last ? T_map_goal : guides[stops[i]], most, iterations);
      if (leg.empty() && is_last) return {};
      if (leg.empty()) continue;  // the next stop may be easier to get to
      corners.insert(corners.end(), leg.begin() + 1, leg.end());
      if (!is_last) begin = stops[i];
    }
    return corners;
  }

  /// Where the shortest way of a disc leads through what the rectangle cannot turn in: along poses in each
  /// of which it fits.
  std::vector<slam::Pose2> GrowOnRaster(const GeodesicField& reachable, const slam::Pose2& T_map_start,
                                        const slam::Pose2& T_map_goal, int& iterations) {
    const std::vector<slam::Pose2> poses =
        internal::PosesOnRaster(space_, footprint_, T_map_start, T_map_goal, kMostRasterPoses);
    if (poses.empty()) return {};
    const auto stops = internal::StopsAmong(space_, poses, kShortStep, kLongStep);
    return GrowLegs(reachable, T_map_start, T_map_goal, poses, stops, options_.max_iterations * 3 / 4,
                    iterations);
  }

  /// Where a robot that cannot go backward has to leave the shortest way to turn about.
  std::vector<slam::Pose2> SearchForward(double radius, const slam::Pose2& T_map_start,
                                         const slam::Pose2& T_map_goal) const {
    const GeodesicField from_goal = DistancesFrom(space_, footprint_.CentreAt(T_map_goal), radius);
    const auto is_free = [this](const slam::Pose2& from, const slam::Pose2& to) {
      return internal::IsMotionFree(space_, footprint_, model_, from, to);
    };
    return internal::ForwardWay(from_goal, footprint_, T_map_start, T_map_goal, options_.turning_radius,
                                is_free, kMostForwardPoses);
  }

  /// The corners of a path; empty where none is found.
  std::vector<slam::Pose2> Grow(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal, int most,
                                int& iterations) {
    if (IsSame(T_map_start, T_map_goal)) return {T_map_start, T_map_goal};
    if (most <= 0) return {};
    const ob::SpaceInformationPtr info = MakeInformation();
    ob::ScopedState<ob::SE2StateSpace> start(model_.state_space()), goal(model_.state_space());
    internal::SetState(T_map_start, start.get());
    internal::SetState(T_map_goal, goal.get());
    const auto problem = std::make_shared<ob::ProblemDefinition>(info);
    problem->setStartAndGoalStates(start, goal);
    SeededRrtConnect planner(info, seed_);
    planner.setRange(options_.range);
    planner.setProblemDefinition(problem);
    planner
        .setNearestNeighbors<internal::PlaneNeighbors>();  // OMPL's, but for the linear one, draw numbers
    int asked = 0;
    planner.solve(ob::PlannerTerminationCondition([most, &asked] { return asked++ >= most; }));
    iterations += std::min(asked, most);
    if (!problem->hasExactSolution()) return {};
    std::vector<slam::Pose2> corners;
    const auto& path = static_cast<const og::PathGeometric&>(*problem->getSolutionPath());
    for (std::size_t i = 0; i < path.getStateCount(); ++i) {
      corners.push_back(internal::PoseOf(path.getState(static_cast<unsigned>(i))));
    }
    corners.front() = T_map_start;
    corners.back() = T_map_goal;
    return corners;
  }

  std::vector<slam::Pose2> Simplified(const std::vector<slam::Pose2>& corners) {
    const ob::SpaceInformationPtr info = MakeInformation();
    og::PathGeometric path(info);
    ob::ScopedState<ob::SE2StateSpace> state(model_.state_space());
    for (const slam::Pose2& corner : corners) {
      internal::SetState(corner, state.get());
      path.append(state.get());
    }
    // Long paths take more, and leave out no more than what lies in one another's sight.
    const double share = std::min(1.0, kInSight / path.length());
    const auto attempts = static_cast<unsigned>(std::lround(options_.simplifications / share));
    if (attempts == 0) return corners;  // which OMPL takes for its default
    SeededSimplifier simplifier(info, seed_);
    simplifier.reduceVertices(path, attempts, attempts, share);
    // Places between the corners too; a part of a shortest way forward need not be one in OMPL's eyes.
    if (options_.model != PathModel::kDubins) simplifier.shortcutPath(path, attempts, attempts, share);
    simplifier.collapseCloseVertices(path, attempts, attempts);
    std::vector<slam::Pose2> simplified;
    for (const ob::State* kept : path.getStates()) simplified.push_back(internal::PoseOf(kept));
    simplified.front() = corners.front();
    simplified.back() = corners.back();
    return simplified;
  }

  PathResult Dense(const std::vector<slam::Pose2>& corners, PathResult& result) const {
    result.status = PathStatus::kFound;
    result.poses = {corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
      std::vector<slam::Pose2> between{corners[i]};
      if (!IsSame(corners[i - 1], corners[i]))
        between = model_.BetweenByFrame(corners[i - 1], corners[i], options_.step);
      between.back() = corners[i];  // without the rounding of its arcs
      result.poses.insert(result.poses.end(), between.begin(), between.end());
    }
    for (std::size_t i = 1; i < result.poses.size(); ++i) {
      result.length += (result.poses[i].translation - result.poses[i - 1].translation).norm();
    }
    return result;
  }

  const FreeSpace& space_;
  const PathOptions& options_;
  std::uint64_t seed_;
  Footprint footprint_;
  internal::MotionModel model_;
  internal::PathSamples samples_{};
};

void RequirePose(const slam::Pose2& pose, std::string_view name) {
  if (pose.translation.allFinite() && std::isfinite(pose.angle)) return;
  Fail("the path's {} ({}, {}, {} rad) is no pose", name, pose.translation.x(), pose.translation.y(),
       pose.angle);
}

}  // namespace

PathResult PlanPath(const FreeSpace& space, const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                    const PathOptions& options, std::uint64_t seed) {
  CheckOptions(options, "path.");
  RequirePose(T_map_start, "start");
  RequirePose(T_map_goal, "goal");
  const internal::OmplSilence silence;
  if (space.columns() == 0) return {.status = PathStatus::kStartNotFree, .poses = {}};
  return PathPlanner(space, options, seed).Plan(T_map_start, T_map_goal);
}

std::vector<bool> ReachableGoals(const FreeSpace& space, const slam::Pose2& T_map_start,
                                 std::span<const slam::Pose2> T_map_goals,
                                 const FootprintOptions& footprint) {
  RequirePose(T_map_start, "start");
  for (const slam::Pose2& goal : T_map_goals) RequirePose(goal, "goal");
  if (space.columns() == 0) return std::vector<bool>(T_map_goals.size(), false);
  return internal::GoalsOnRaster(space, Footprint(footprint), T_map_start, T_map_goals);
}

}  // namespace ariadne::planning
