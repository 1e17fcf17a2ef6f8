#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "experiments/mission/planned_drive.h"

namespace ariadne::experiments {

/// The spaces of one height.
struct Spaces {
  planning::FreeSpace free;   // of all that is known to stand in the way
  planning::FreeSpace clear;  // and of what may
};

/// For a robot that stands somewhere; what it touches there by turning is clear.
Spaces SpacesAt(const Surroundings& around, std::size_t height, const slam::Pose2& T_map_base,
                const planning::FreeSpaceOptions& options);

using PlanDrive =
    std::function<std::optional<PlannedDrive>(const Spaces& spaces, const slam::Pose2& T_map_goal)>;

/// Hands in the ways to get to a goal, the best first, until somebody has no need of more: paths that
/// keep their whole margin and are clear, then with half of it; paths that only have nothing known in their
/// way, likewise; one of these after going back the way that the robot came. Before these, or instead, what
/// the paper tries, if options.drive_by says so.
void TryWays(const Surroundings& around, const slam::Pose2& T_map_base, const MissionOptions& options,
             std::uint64_t seed, const std::function<void(const PlanDrive&)>& attempt);

/// Which goals there may be a path to, with the least margin that is tried.
std::vector<bool> MayHaveAPath(const Spaces& spaces, const Surroundings& around,
                               const slam::Pose2& T_map_base, std::span<const slam::Pose2> T_map_goals,
                               const MissionOptions& options);

/// Where the rectangle has no path, the way of a disc; by giving way the robot may get there all the same.
/// Nothing where a disc has none, or only the paper's ways are to be tried.
std::optional<PlannedDrive> DriveOfDisc(const planning::FreeSpace& space, const slam::Pose2& T_map_base,
                                        const slam::Pose2& T_map_goal, const MissionOptions& options);

}  // namespace ariadne::experiments
