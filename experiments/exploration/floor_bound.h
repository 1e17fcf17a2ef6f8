#pragma once

#include <vector>

#include "experiments/bounds/minimum_cover.h"
#include "experiments/exploration/floor_cover.h"
#include "planning/path/free_space.h"

namespace ariadne::experiments {

struct FloorBoundOptions {
  double place_spacing = 2.0;
  int headings = 8;
  double robot_radius = 0.3;
  CoverOptions cover;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("place_spacing", self.place_spacing, Unit("m"), Range{0.1, 20.0},
          "between the places from which the fewest views are chosen");
    visit("headings", self.headings, Unit(""), Range{1, 360}, "that are tried in each place");
    visit("robot_radius", self.robot_radius, Unit("m"), Range{0.05, 5.0},
          "of the disc that drives the tour");
    visit("cover", self.cover, "how much must be seen, and how long the fewest views are searched for");
  }
};

/// The fewest views by which one who knows the floor could see a share of its cover, and how few it can be
/// at best among the places and headings that were tried.
struct FloorBound {
  std::vector<slam::Pose2> views;
  int lower_bound = 0;      // of the number of views
  double covered = 0.0;     // share of the cover
  Eigen::MatrixXd ways_to;  // between the views [m]
};

FloorBound FindFloorBound(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorCover& cover, const planning::FreeSpace& free,
                          const FloorScannerOptions& scanner, const FloorBoundOptions& options,
                          const Parallel& parallel);

/// The lengths of the shortest ways of a disc between all pairs of views [m]; infinite: there is none.
Eigen::MatrixXd WaysBetween(const std::vector<slam::Pose2>& views, const planning::FreeSpace& free,
                            double robot_radius);

/// The length of a short tour from a start through all views of the bound [m]. Error where a disc cannot
/// get from one to the other.
double TourLength(const FloorBound& bound, const Eigen::Vector2d& start, const planning::FreeSpace& free,
                  double robot_radius);

/// What is free on a floor: all that can be seen from any of the places.
planning::FreeSpace FreeFloor(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                              const FloorScannerOptions& scanner, double place_spacing);

}  // namespace ariadne::experiments
