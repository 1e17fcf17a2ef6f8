#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "experiments/studies/plan_step.h"
#include "slam/io/svg.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// Fig. 6: one step of planning from one 3D scan: points at a height, lines, polygon, the order of the
/// lines, candidates, and the chosen pose.
struct Fig06Options {
  InputOptions input = InputOptions::OfTour();
  slam::ScanFilterOptions scan;
  PlanStepOptions step;
  slam::SvgOptions svg;
  int width = 900;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scan; the first is taken");
    visit("scan", self.scan, "which of its points are measurements");
    visit("step", self.step, "from the scan to the next view");
    visit("svg", self.svg, "how the plan is drawn on paper");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of each panel");
  }
};

/// Returns what to print.
std::string RunFig06(const Fig06Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
