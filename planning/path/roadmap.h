#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/path/free_space.h"

namespace ariadne::planning {

struct RoadmapOptions {
  int vertices = 1000;
  int max_draws = 50;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("vertices", self.vertices, Unit(""), Range{1, 100000}, "places that are drawn and joined");
    visit("max_draws", self.max_draws, Unit(""), Range{1, 100000},
          "per vertex, on average; after that, there is too little room to be found");
  }
};

/// Places where a disc has room, and straight ways between them that it can go.
struct Roadmap {
  struct Way {
    std::size_t from, to;  // vertices
    double length;         // [m]
  };
  double radius = 0.0;                        // of the disc [m]
  std::vector<Eigen::Vector2d> vertices_map;  // [m]
  std::vector<Way> ways;                      // each once
};

/// PRM* (Karaman, Frazzoli 2011; OMPL): places drawn uniformly, each joined to the k nearest before it, k
/// growing as is needed for lengths that approach the shortest ones. Fewer vertices where there is no room.
/// The same arguments give the same bytes. Error for options out of their range and for a bad radius.
Roadmap BuildRoadmap(const FreeSpace& space, double radius, const RoadmapOptions& options,
                     std::uint64_t seed);

/// Lengths of the ways through the roadmap from a place to others, all of which are joined to the nearest
/// vertices that a disc can reach straight; infinity where there is none. Always at least a shortest way's;
/// the straight way is taken where it is free [m].
std::vector<double> RoadmapDistances(const FreeSpace& space, const Roadmap& roadmap,
                                     const Eigen::Vector2d& start_map,
                                     std::span<const Eigen::Vector2d> places_map);

}  // namespace ariadne::planning
