#pragma once

#include <string>

#include "control/approach_plan.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "experiments/studies/plan_step.h"
#include "slam/map/surface_model.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// Fig. 10: trajectories to next best views in the polygon of a scan, around the boxes of its objects, by
/// the controller and by each of its two fallbacks.
struct Fig10Options {
  InputOptions input = InputOptions::OfTour();
  slam::ScanFilterOptions scan;
  PlanStepOptions step;
  slam::SurfaceModelOptions surfaces;
  control::ApproachPlanOptions drive;
  double lowest = 0.05;
  double highest = 1.1;
  int headings = 8;
  int width = 900;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scan; the first is taken");
    visit("scan", self.scan, "which of its points are measurements");
    visit("step", self.step, "from the scan to the views");
    visit("surfaces", self.surfaces, "from the scan to the boxes");
    visit("drive", self.drive, "how the robot drives");
    visit("lowest", self.lowest, Unit("m"), Range{0.0, 10.0},
          "above the floor: lower boxes are no obstacles");
    visit("highest", self.highest, Unit("m"), Range{0.0, 10.0},
          "the top of the scanner: boxes above it are no obstacles");
    visit("headings", self.headings, Unit(""), Range{1, 360},
          "of the robot at the scan's place that are tried until each behaviour is needed; the first is "
          "its own");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of each panel");
  }
};

/// Returns what to print.
std::string RunFig10(const Fig10Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
