#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/mission/mission_map.h"

namespace ariadne::experiments {

/// What is to be driven next, and why.
struct PlannedDrive {
  std::optional<planning::View> view;    // none: back to a place where the robot has been
  std::vector<slam::Pose2> path_map;     // from where the robot stands; its frame, and how it is turned
  std::size_t height = 0;                // in whose slice the view was planned
  std::size_t rank = 0;                  // 0: the best of the views
  bool leg_only = false;                 // the path ends before the view
  bool of_disc = false;                  // the rectangle has no path; this is a disc's
  double margin = 0.0;                   // that the path keeps beside the rectangle [m]
  std::optional<ApproachTask> approach;  // the path is what it is expected to drive
};

/// What planning looks at.
struct Surroundings {
  std::vector<std::vector<planning::LabelledPolygon>> areas;  // by height
  std::vector<Eigen::Vector2d> obstacles_map;
  std::vector<Eigen::Vector2d> unclear_map;  // where something may stand that no scan has met
  std::vector<slam::Pose2> T_map_scans;
  std::vector<slam::Pose2> trail_map;  // driven last, to where the robot stands
};

Surroundings SurroundingsOf(MissionMap& map, std::span<const slam::Pose2> trail_map);

/// A target of an earlier drive that ended at an obstacle.
struct FailedTarget {
  Eigen::Vector2d p_map = Eigen::Vector2d::Zero();
  int times = 0;
};

/// The next view and the path there (Sec. 4.2, 5.2): of all heights' views the one with the highest value
/// that the rectangle has a path to with its whole margin, after it has gone back the way that it came
/// until there is room for it; if the best few have none, with half of it; and at last the best view by
/// the way of a disc. Places where drives have failed twice are passed over. Nothing where no view is worth
/// a scan. Before each of these is taken, what no scan shows to be clear counts too: a path ends before it,
/// or goes round it.
std::optional<PlannedDrive> PlanNextDrive(const Surroundings& around, const slam::Pose2& T_map_base,
                                          std::span<const FailedTarget> failed,
                                          const MissionOptions& options, std::uint64_t seed);

/// A path to a place where the robot has been.
std::optional<PlannedDrive> PlanDriveTo(const Surroundings& around, const slam::Pose2& T_map_base,
                                        const slam::Pose2& T_map_goal, const MissionOptions& options,
                                        std::uint64_t seed);

}  // namespace ariadne::experiments
