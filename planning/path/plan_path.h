#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/path/footprint.h"

namespace ariadne::planning {

enum class PathModel { kGeometric, kReedsShepp, kDubins };

enum class PathStatus {
  kFound,
  kStartNotFree,  // the robot with its margin stands too near to a wall; plan with less margin
  kGoalNotFree,
  kUnreachable,  // no way is wide enough, whatever the robot's heading
  kNotFound  // within max_iterations; with dubins often since the robot is shut in but for a way backward
};

struct PathOptions {
  PathModel model = PathModel::kReedsShepp;
  double turning_radius = 0.3;
  double range = 3.0;
  int max_iterations = 2000;
  double guided = 0.7;
  int simplifications = 100;
  double step = 0.05;
  FootprintOptions footprint;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("model", self.model,
          "geometric: any direction and turn; reeds_shepp: arcs and lines, forward and backward; dubins: "
          "only "
          "forward");
    visit("turning_radius", self.turning_radius, Unit("m"), Range{0.01, 10.0},
          "the robot can turn on the spot; 0.3 keeps both driven wheels running forward");
    visit("range", self.range, Unit("m"), Range{0.05, 1000.0},
          "of one growth of a tree; below a room's size");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 10000000},
          "of RRT-Connect; counted, not timed, so that a slower computer plans the same");
    visit(
        "guided", self.guided, Unit(""), Range{0.0, 1.0},
        "share of samples near the shortest way of a disc, which finds the doors; the others are uniform");
    visit("simplifications", self.simplifications, Unit(""), Range{0, 100000},
          "attempts to leave out what lies between two places of the path");
    visit("step", self.step, Unit("m"), Range{0.001, 1.0}, "between the poses that are returned, at most");
    visit("footprint", self.footprint, "the robot");
  }
};

struct PathResult {
  PathStatus status = PathStatus::kNotFound;
  std::vector<slam::Pose2>
      poses;            // T_map_robot from the start to the goal, both exact; empty without a path
  double length = 0.0;  // of what the robot's frame moves [m]
  int iterations = 0;   // of RRT-Connect
};

/// A path for the robot's rectangle by RRT-Connect (Kuffner, LaValle 2000; OMPL), simplified: in legs of a
/// few metres along the shortest way of a disc, or where a leg fails, from the start to the goal; with
/// dubins, where that finds none, by hybrid A* over places and headings (forward_way.h). Start and
/// goal within 1 mm and 0.1 deg are joined without a plan. Motions are looked at every 2 cm, or every
/// margin where that is more, of what any corner moves; so the rectangle stays clear by half its margin.
/// The same arguments give the same bytes, whatever ran before.
///
/// Error for poses that are not finite, and for options out of their range.
PathResult PlanPath(const FreeSpace& space, const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                    const PathOptions& options, std::uint64_t seed);

/// Which of the goals the rectangle can get to from a start, by one search for all of them on a raster of
/// poses (that of the space, 10 deg): what is narrow to a cell may count as closed. All, where the space
/// has more than 2.7 million cells.
std::vector<bool> ReachableGoals(const FreeSpace& space, const slam::Pose2& T_map_start,
                                 std::span<const slam::Pose2> T_map_goals,
                                 const FootprintOptions& footprint);

}  // namespace ariadne::planning

template <>
struct ariadne::EnumNames<ariadne::planning::PathModel> {
  static constexpr std::array<std::string_view, 3> value = {"geometric", "reeds_shepp", "dubins"};
};

template <>
struct ariadne::EnumNames<ariadne::planning::PathStatus> {
  static constexpr std::array<std::string_view, 5> value = {"found", "start_not_free", "goal_not_free",
                                                            "unreachable", "not_found"};
};
