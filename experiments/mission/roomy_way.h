#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/path/plan_path.h"

namespace ariadne::experiments {

/// How far a path keeps off what stands beside it, where there is room.
struct RoomOptions {
  double margin = 0.2;
  double detour = 1.3;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("margin", self.margin, Unit("m"), Range{0.0, 10.0},
          "that a path keeps where it can, since scans miss the tips of leaves and the edges of boards; 0, "
          "or less than path.footprint.margin: paths are as short as that one allows");
    visit("detour", self.detour, Unit(""), Range{1.0, 100.0},
          "times as long, and a metre, a piece of a path may get for it");
  }
};

/// A path with more room: the pieces at which the robot comes nearer than `room.margin` to what is not free
/// are planned again with that margin, or else with the mean of it and of the path's own. A piece for which
/// there is no such way, within the detour, stays as it is, and so do both ends. `options` are those that
/// the path was planned with.
std::vector<slam::Pose2> WithRoom(const planning::FreeSpace& space, std::vector<slam::Pose2> path_map,
                                  const planning::PathOptions& options, const RoomOptions& room,
                                  std::uint64_t seed);

}  // namespace ariadne::experiments
