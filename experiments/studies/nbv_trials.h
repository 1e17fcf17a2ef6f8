#pragma once

#include <string>
#include <vector>

#include "experiments/exploration/explore.h"
#include "experiments/exploration/floor_bound.h"

namespace ariadne::experiments {

/// A floor with all that trials on it have in common.
struct NbvFloor {
  Floor floor;
  std::vector<Eigen::Vector2d> reachable;
  FloorCover cover;
  planning::FreeSpace free;
  FloorBound bound;
};

struct NbvFloorOptions {
  double height = 1.5;
  FloorCoverOptions cover;
  FloorBoundOptions bound;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{0.0, 100.0},
          "at which buildings are cut; the paper's 150 cm");
    visit("cover", self.cover, "what is to be seen");
    visit("bound", self.bound, "the fewest views that one who knows the floor needs");
  }
};

/// Loads and cuts a world; the bound is still to be found (nbv_bounds.h).
NbvFloor PrepareFloor(const std::string& world, const NbvFloorOptions& options,
                      const FloorScannerOptions& scanner, const Parallel& parallel);

/// A way of planning under its name in tables.
struct NbvVariant {
  std::string study;  // what is varied
  std::string name;
  ExploreOptions explore;
};

/// One exploration, in numbers.
struct NbvTrial {
  std::string floor, study, variant;
  std::uint64_t seed = 0;
  double scans = 0.0, path = 0.0;        // until it ended [m]
  double scans_95 = 0.0, path_95 = 0.0;  // until the share of the bound was seen; infinite: never
  double covered = 0.0;                  // at the end
  bool ended = false;                    // by itself
  double bound_scans = 0.0, bound_path = 0.0;
  std::vector<double> covered_after;     // each scan
  std::vector<double> path_after;        // each scan [m]
  std::vector<double> planning_seconds;  // not deterministic
};

/// Seed 1 begins where the floor's file says, others anywhere that can be reached, with any heading.
NbvTrial TryNbv(const NbvFloor& floor, const NbvVariant& variant, double share, std::uint64_t seed);

}  // namespace ariadne::experiments
