#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/exploration/floor_cover.h"
#include "planning/polygon/labelled_union.h"
#include "planning/view/view_planner.h"

namespace ariadne::experiments {

/// What counts as the way to a view.
enum class ExploreWay {
  kPlanner,           // what the planner's option says
  kControllerLength,  // of what the controller of Sec. 5.1 drives along the corners of the way
  kControllerTime,    // and how long it takes, at full speed for each metre
};

struct ExploreOptions {
  ExploreWay way = ExploreWay::kPlanner;
  planning::ViewPlannerOptions planner;
  planning::LabelledUnionOptions united;
  FloorScannerOptions scanner;
  int max_scans = 400;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("way", self.way,
          "what counts as the way to a view: the planner's option, or what a simulation of the controller "
          "drives (5.1), as its length or its time");
    visit("planner", self.planner, "where to scan next");
    visit("united", self.united, "how the scans' polygons are united");
    visit("scanner", self.scanner, "what a scan shows");
    visit("max_scans", self.max_scans, Unit(""), Range{1, 100000},
          "after which an exploration is given up");
  }
};

/// A scan, and what came before it.
struct ExploreStep {
  slam::Pose2 T_map_scan;
  double path = 0.0;              // driven up to here [m]
  double covered = 0.0;           // share of the cover that has been seen, with this scan
  int gain = 0;                   // rays, as planned
  double planning_seconds = 0.0;  // of the decision for this scan; not deterministic
};

struct Exploration {
  std::vector<ExploreStep> steps;
  bool ended = false;  // by itself: nothing was left that is worth a scan
  std::vector<planning::LabelledPolygon> area;
};

/// The loop of Sec. 4 in the plane, with exact poses: scan, unite, plan, go there, scan. Ways lead through
/// what is known to be free and are driven as planned.
Exploration Explore(const Floor& floor, const FloorCover& cover, const slam::Pose2& T_map_start,
                    const ExploreOptions& options, std::uint64_t seed);

/// How many scans, or how much way [m], it took to cover a share; infinite where it was not reached.
double ScansTo(const Exploration& exploration, double share);
double PathTo(const Exploration& exploration, double share);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::ExploreWay> {
  static constexpr std::array<std::string_view, 3> value{"planner", "controller_length", "controller_time"};
};

}  // namespace ariadne
