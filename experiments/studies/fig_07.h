#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "experiments/studies/plan_step.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// Fig. 7: the labelled polygons of two registered scans, and their union.
struct Fig07Options {
  InputOptions input = InputOptions::OfTour();
  slam::MapperOptions mapper;
  PlanStepOptions step;
  int width = 900;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scans; the first two are taken");
    slam::MapperOptions::Visit(self.mapper, visit);
    visit("step", self.step, "from the scans to polygons and their union");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of each panel");
  }
};

/// Error where there are fewer than two scans. Returns what to print.
std::string RunFig07(const Fig07Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
