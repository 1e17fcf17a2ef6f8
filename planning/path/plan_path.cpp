#include "planning/path/plan_path.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "planning/path/geodesic.h"
#include "planning/path/motion_model.h"
#include "planning/path/ompl_support.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kSamePlace = 1e-3;                                        // [m]
constexpr double kSameAngle = 0.1 * std::numbers::pi / 180.0;              // [rad]
constexpr double kGuideStep = 0.25, kGuideShift = 0.05;                    // [m]
constexpr double kGuideSpread = 0.3;                                       // [m]
constexpr double kGuideTurn = 20.0 * std::numbers::pi / 180.0;             // [rad]
constexpr int kGuideHeadings = 30;                                         // to each side
constexpr double kGuideHeading = 0.5 * std::numbers::pi / kGuideHeadings;  // [rad]

/// What is near a way comes from here, and the places that a disc within the robot can reach.
struct Samples {
  std::vector<slam::Pose2> guides;
  std::vector<Eigen::Vector2d> cells;  // centres [m]
  double cell;                         // their size [m]
};

/// Across the way to where most room is, if there is little: the shortest way of a disc touches the corners
/// of a door, and the robot needs its middle.
Eigen::Vector2d Centred(const FreeSpace& space, const Eigen::Vector2d& p_map, const Eigen::Vector2d& side,
                        double enough) {
  Eigen::Vector2d best = p_map;
  double most = std::min(enough, space.Clearance(p_map));
  for (double away = kGuideShift; away < enough; away += kGuideShift) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector2d p = p_map + sign * away * side;
      const double clearance = std::min(enough, space.Clearance(p));
      if (clearance > most + 1e-9) most = clearance, best = p;
    }
  }
  return best;
}

/// The middle of the headings, within a right angle of the way's, in which the robot fits there.
std::optional<double> FittingHeading(const FreeSpace& space, const Footprint& footprint,
                                     const slam::Pose2& T_map_way) {
  const auto fits = [&](int i) {
    return std::abs(i) <= kGuideHeadings &&
           footprint.IsFree(space, {T_map_way.angle + i * kGuideHeading, T_map_way.translation});
  };
  if (fits(0) && fits(-2) && fits(2)) return T_map_way.angle;
  for (int i = 0; i <= kGuideHeadings; ++i) {
    for (const int sign : {-1, 1}) {
      if (!fits(sign * i)) continue;
      int low = sign * i, high = low;
      while (fits(low - 1)) --low;
      while (fits(high + 1)) ++high;
      return T_map_way.angle + 0.5 * (low + high) * kGuideHeading;
    }
  }
  return std::nullopt;
}

std::vector<slam::Pose2> GuidesAlong(const FreeSpace& space, const Footprint& footprint,
                                     const std::vector<Eigen::Vector2d>& way) {
  std::vector<slam::Pose2> guides;
  const double enough = footprint.reach() + footprint.options().margin;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Eigen::Vector2d along = way[i] - way[i - 1];
    const int count = std::max(1, static_cast<int>(std::ceil(along.norm() / kGuideStep)));
    const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()).normalized();
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector2d p = Centred(space, way[i - 1] + along * (k + 0.5) / count, side, enough);
      const slam::Pose2 guide{std::atan2(along.y(), along.x()), p};
      if (const auto heading = FittingHeading(space, footprint, guide)) guides.push_back({*heading, p});
    }
  }
  return guides;
}

Samples FindSamples(const FreeSpace& space, const Footprint& footprint, const GeodesicField& reachable,
                    const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal) {
  Samples samples{{}, {}, space.resolution()};
  for (int row = 0; row < space.rows(); ++row) {
    for (int column = 0; column < space.columns(); ++column) {
      if (reachable.IsReachable({column, row})) samples.cells.push_back(space.CentreOf({column, row}));
    }
  }
  const GeodesicField field = DistancesFrom(space, T_map_start.translation, footprint.least_radius());
  std::vector<Eigen::Vector2d> way = field.PathTo(T_map_goal.translation);
  if (way.empty()) way = reachable.PathTo(T_map_goal.translation);
  samples.guides = GuidesAlong(space, footprint, way);
  return samples;
}

class PoseSampler : public ob::StateSampler {
 public:
  PoseSampler(const ob::StateSpace* space, RandomStream stream, const Samples& samples, double guided)
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
  const Samples& samples_;
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
    // Every place on a way of the robot is within 1.5 cells of a cell that is free for this radius.
    const double radius = std::max(0.0, footprint_.least_radius() - 1.5 * space_.resolution());
    const GeodesicField reachable = DistancesFrom(space_, T_map_start.translation, radius);
    if (std::isinf(reachable.To(T_map_goal.translation)))
      return result.status = PathStatus::kUnreachable, result;
    samples_ = FindSamples(space_, footprint_, reachable, T_map_start, T_map_goal);
    return Grow(T_map_start, T_map_goal, result);
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

  PathResult Grow(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal, PathResult& result) {
    const ob::SpaceInformationPtr info = MakeInformation();
    ob::ScopedState<ob::SE2StateSpace> start(model_.state_space()), goal(model_.state_space());
    internal::SetState(T_map_start, start.get());
    internal::SetState(T_map_goal, goal.get());
    const auto problem = std::make_shared<ob::ProblemDefinition>(info);
    problem->setStartAndGoalStates(start, goal);
    SeededRrtConnect planner(info, seed_);
    planner.setRange(options_.range);
    planner.setProblemDefinition(problem);
    planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();  // other structures draw numbers
    const int most = options_.max_iterations;
    int* iterations = &result.iterations;
    planner.solve(ob::PlannerTerminationCondition([most, iterations] { return (*iterations)++ >= most; }));
    result.iterations = std::min(result.iterations, most);
    if (!problem->hasExactSolution()) return result;
    og::PathGeometric path(static_cast<const og::PathGeometric&>(*problem->getSolutionPath()));
    Simplify(info, path);
    std::vector<slam::Pose2> corners;
    for (const ob::State* state : path.getStates()) corners.push_back(internal::PoseOf(state));
    corners.front() = T_map_start;
    corners.back() = T_map_goal;
    return Dense(corners, result);
  }

  void Simplify(const ob::SpaceInformationPtr& info, og::PathGeometric& path) const {
    const auto attempts = static_cast<unsigned>(options_.simplifications);
    if (attempts == 0) return;  // which OMPL takes for its default
    SeededSimplifier simplifier(info, seed_);
    simplifier.reduceVertices(path, attempts, attempts, 1.0);
    // Places between the corners too; a part of a shortest way forward need not be one in OMPL's eyes.
    if (options_.model != PathModel::kDubins) simplifier.shortcutPath(path, attempts, attempts, 1.0);
    simplifier.collapseCloseVertices(path, attempts, attempts);
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
  Samples samples_{};
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

}  // namespace ariadne::planning
