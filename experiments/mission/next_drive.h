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
