#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "experiments/mission/planned_drive.h"

namespace ariadne::experiments {

/// A target of an earlier drive that ended at an obstacle.
struct FailedTarget {
  Eigen::Vector2d p_map = Eigen::Vector2d::Zero();
  int times = 0;
  bool of_disc = false;
};

/// The next view and the path there (Sec. 4.2, 5.2). Of all heights' views the best few that there may be a
/// path to are tried: the one with the highest value that the rectangle has a path to with its whole
/// margin, after it has gone back the way that it came until there is room for it; if none has one, with
/// half of it. Then the best few of all, with few trials, and at last the best view by the way of a disc.
/// Places where drives have failed twice are passed over, and so are those near where the way of a disc
/// has. Nothing where no view is worth a scan. Before each of these is taken, what no scan shows to be
/// clear counts too: a path ends before it, or goes round it.
std::optional<PlannedDrive> PlanNextDrive(const Surroundings& around, const slam::Pose2& T_map_base,
                                          std::span<const FailedTarget> failed,
                                          const MissionOptions& options, std::uint64_t seed);

/// A path to a place where the robot has been.
std::optional<PlannedDrive> PlanDriveTo(const Surroundings& around, const slam::Pose2& T_map_base,
                                        const slam::Pose2& T_map_goal, const MissionOptions& options,
                                        std::uint64_t seed);

/// Back the way that the robot came, so far from where it stands [m].
PlannedDrive PlanRetreat(std::span<const slam::Pose2> trail_map, double away);

/// The same where nothing leads to a view, as far as something does: the map shows too little room where
/// the robot came through, in a door for example. Nothing where none of the last 12 m does.
std::optional<PlannedDrive> PlanWayOut(const Surroundings& around, std::span<const FailedTarget> failed,
                                       const MissionOptions& options, std::uint64_t seed);

}  // namespace ariadne::experiments
