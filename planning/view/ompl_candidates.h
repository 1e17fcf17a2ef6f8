#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "planning/path/free_space.h"

namespace ariadne::planning {

/// Where candidates for the next view come from. kUniform is DrawCandidates (uniform_candidates.h), the
/// paper's; the others are OMPL's, for comparison.
enum class CandidateSampler {
  kUniform,
  kOmplUniform,
  kObstacleBased,      // next to what blocks (Amato et al. 1998)
  kGaussian,           // near to what blocks (Boor, Overmars, van der Stappen 1999)
  kBridgeTest,         // between two that block, as in doors (Hsu et al. 2003)
  kMaximizeClearance,  // the widest of a few (Hsu's and OMPL's)
  kRoadmap             // the vertices of PRM*: uniform too, others than of kOmplUniform
};

struct OmplCandidateOptions {
  int count = 200;
  double std_dev = 1.0;
  int improvements = 3;
  int max_draws = 500;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("count", self.count, Unit(""), Range{1, 1000000},
          "places to look at, as for the paper's sampler");
    visit(
        "std_dev", self.std_dev, Unit("m"), Range{0.01, 1000.0},
        "between the two places of gaussian and bridge_test; OMPL's default is a share of the map's size, "
        "1 m is a door's width");
    visit("improvements", self.improvements, Unit(""), Range{1, 1000},
          "of maximize_clearance: places of which the widest is kept; OMPL's default");
    visit("max_draws", self.max_draws, Unit(""), Range{1, 100000},
          "per candidate, on average; the bridge test takes one of 300 in a hall with three pillars");
  }
};

/// Places where a disc of the radius [m] has room, by one of OMPL's samplers. Fewer than asked for, or
/// none, where there is too little room. The same arguments give the same places. Error for options out of
/// their range, for a bad radius, and for kUniform, which takes polygons.
std::vector<Eigen::Vector2d> DrawOmplCandidates(const FreeSpace& space, double radius,
                                                CandidateSampler sampler,
                                                const OmplCandidateOptions& options, std::uint64_t seed);

}  // namespace ariadne::planning

template <>
struct ariadne::EnumNames<ariadne::planning::CandidateSampler> {
  static constexpr std::array<std::string_view, 7> value{"uniform",  "ompl_uniform", "obstacle_based",
                                                         "gaussian", "bridge_test",  "maximize_clearance",
                                                         "roadmap"};
};
