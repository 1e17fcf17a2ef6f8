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

Spaces SpacesAt(const Surroundings& around, std::size_t height, const planning::FreeSpaceOptions& options);

using PlanDrive =
    std::function<std::optional<PlannedDrive>(const Spaces& spaces, const slam::Pose2& T_map_goal)>;

/// Hands in the ways to get to a goal, the best first, until somebody has no need of more: paths that
/// keep their whole margin and are clear, then with half of it; paths that only have nothing known in their
/// way, likewise; one of these after going back the way that the robot came; the way of a disc. Before
/// these, or instead, what the paper tries, if options.drive_by says so.
void TryWays(const Surroundings& around, const slam::Pose2& T_map_base, const MissionOptions& options,
             std::uint64_t seed, const std::function<void(const PlanDrive&)>& attempt);

}  // namespace ariadne::experiments
