#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/polygon/labelled_union.h"
#include "planning/polygon/scan_polygon.h"
#include "planning/view/view_planner.h"

namespace ariadne::experiments {

/// One step of planning (Sec. 4.2, 4.3): from registered scans to the place of the next.
struct PlanStepOptions {
  double height = 1.5;
  bool from_floor = true;
  planning::ScanPolygonOptions polygon;
  planning::LabelledUnionOptions united;
  planning::ViewPlannerOptions planner;
  double stand_radius = 0.45;
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{-1000.0, 1000.0},
          "of the slice; 150 cm is the paper's (4.2). It takes the place of polygon.slice.height");
    visit("from_floor", self.from_floor,
          "whether the height counts from the floor that the scans show, or is z of the map");
    visit("polygon", self.polygon, "what a scan shows to be free");
    visit("united", self.united, "how the scans' polygons are united");
    visit("planner", self.planner, "where to scan next");
    visit("stand_radius", self.stand_radius, Unit("m"), Range{0.0, 10.0},
          "free around a scanner where it has stood, also behind it, but not beyond walls that are seen: "
          "the robot's radius and the clearance of ways");
    visit("seed", self.seed, Unit(""), Range{0, 2147483647}, "of the candidates");
  }
};

struct PlanStep {
  double slice_z = 0.0;                       // of the slice in the map [m]
  std::vector<slam::HorizontalSlice> slices;  // one per scan
  std::vector<std::vector<planning::SliceLine>> lines;
  std::vector<planning::LabelledPolygon> polygons;
  std::vector<planning::LabelledPolygon> area;  // their union, with where the robot stood
  slam::Pose2 T_map_robot;                      // where the last scan was taken, x to where it looked
  planning::ViewPlan plan;
};

/// z of the floor: where most points below all lasers lie. Error where there are none [m].
double FloorUnder(std::span<const slam::PosedCloud> scans);

/// Error where there are no scans, or where they show nothing at that height.
PlanStep PlanNextScan(std::span<const slam::PosedCloud> scans, const PlanStepOptions& options);

}  // namespace ariadne::experiments
