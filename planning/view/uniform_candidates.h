#pragma once

#include <cstdint>
#include <functional>

#include "planning/view/edge_set.h"
#include "slam/base/options.h"

namespace ariadne::planning {

struct CandidateOptions {
  int count = 200;
  double wall_clearance = 0.0;
  double unseen_clearance = 0.0;
  int max_draws = 50;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("count", self.count, Unit(""), Range{1, 1000000}, "places to look at; Fig. 6 shows 200");
    visit("wall_clearance", self.wall_clearance, Unit("m"), Range{0.0, 100.0},
          "from seen edges; the paper has none (0) and leaves it to the path");
    visit("unseen_clearance", self.unseen_clearance, Unit("m"), Range{0.0, 100.0},
          "from unseen edges, behind which anything may stand; 0 as in the paper, so that doorways of "
          "unknown rooms stay places to go");
    visit("max_draws", self.max_draws, Unit(""), Range{1, 100000},
          "per candidate, on average; after that, what keeps its clearance is too small to be found");
  }
};

/// Places drawn uniformly from the inside of polygons that do not overlap, holes left out (Sec. 4.2 step
/// 4): a triangle by its area, then a place in it. Edges are those to keep clear of. Fewer than asked for,
/// or none, where there is too little room. The same seed gives the same places; they depend on the frame
/// of the polygons, their distribution does not. Error for corners or ends of edges that are no places.
std::vector<Eigen::Vector2d> DrawCandidates(std::span<const slam::Polygon2> area,
                                            std::span<const Edge> edges, const CandidateOptions& options,
                                            std::uint64_t seed);

/// Whether a place is wanted; no place outside of the area is.
using IsWantedCandidate = std::function<bool(const Eigen::Vector2d& p_map)>;

/// Of the places that DrawCandidates gives the first `count` that are wanted, without drawing the others.
std::vector<Eigen::Vector2d> DrawWantedCandidates(std::span<const slam::Polygon2> area,
                                                  std::span<const Edge> edges,
                                                  const CandidateOptions& options, std::uint64_t seed,
                                                  int count, const IsWantedCandidate& is_wanted);

}  // namespace ariadne::planning
