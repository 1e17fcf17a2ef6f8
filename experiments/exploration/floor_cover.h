#pragma once

#include <cstdint>
#include <vector>

#include "experiments/exploration/floor_view.h"
#include "slam/base/parallel.h"

namespace ariadne::experiments {

struct FloorCoverOptions {
  double radius = 0.35;
  double resolution = 0.1;
  double place_spacing = 1.0;
  double sample_spacing = 0.1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("radius", self.radius, Unit("m"), Range{0.05, 2.0},
          "free around a place that counts as reachable: half the robot's width, and a margin");
    visit("resolution", self.resolution, Unit("m"), Range{0.01, 1.0}, "of the grid on which it is decided");
    visit("place_spacing", self.place_spacing, Unit("m"), Range{0.1, 10.0},
          "between the places from which all that can be seen is looked at");
    visit("sample_spacing", self.sample_spacing, Unit("m"), Range{0.01, 1.0}, "along walls");
  }
};

/// Places connected with the start by steps of the grid, all of them farther than the radius from any wall.
/// The nearest such place to the start counts as the start. Error where there is none within 1 m.
std::vector<Eigen::Vector2d> ReachableFloor(const Floor& floor, const FloorCoverOptions& options);

/// Of the places the first in each square of a grid of `spacing` [m].
std::vector<Eigen::Vector2d> Thinned(const std::vector<Eigen::Vector2d>& places, double spacing);

/// The places on walls, and on whatever else stands upright, that can be seen from where the robot can be:
/// what an exploration is to find.
struct FloorCover {
  std::vector<Eigen::Vector2d> places_map;
  double length_each = 0.0;  // of wall that a place stands for [m]
};

/// A floor and what of it there is to see.
struct FloorToExplore {
  Floor floor;
  FloorCover cover;
};

FloorCover FindFloorCover(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorScannerOptions& scanner, const FloorCoverOptions& options,
                          const Parallel& parallel);

/// The numbers of the places that a view shows, ascending.
std::vector<std::uint32_t> SeenPlaces(const FloorView& view, const FloorCover& cover,
                                      const FloorScannerOptions& scanner);

}  // namespace ariadne::experiments
