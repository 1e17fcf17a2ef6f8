#pragma once

#include <optional>
#include <vector>

#include "experiments/bounds/minimum_cover.h"
#include "experiments/exploration/floor_cover.h"

namespace ariadne::experiments {

struct FloorBoundOptions {
  double place_spacing = 2.0;
  int headings = 8;
  CoverOptions cover;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("place_spacing", self.place_spacing, Unit("m"), Range{0.1, 20.0},
          "between the places from which the fewest views are chosen");
    visit("headings", self.headings, Unit(""), Range{1, 360}, "that are tried in each place");
    visit("cover", self.cover, "how much must be seen, and how long the fewest views are searched for");
  }
};

/// The fewest views by which one who knows the floor could see a share of its cover, and how few it can be
/// at best among the places and headings that were tried. The first view is where the robot starts.
struct FloorBound {
  std::vector<slam::Pose2> views;  // the first is the start
  int lower_bound = 0;             // of the number of views
  double covered = 0.0;            // share of the cover
};

FloorBound FindFloorBound(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorCover& cover, const slam::Pose2& T_map_start,
                          const FloorScannerOptions& scanner, const FloorBoundOptions& options,
                          const Parallel& parallel);

}  // namespace ariadne::experiments
