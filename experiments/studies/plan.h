#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/plan_step.h"
#include "slam/io/svg.h"

namespace ariadne::experiments {

/// The experiment `plan`: where to scan next, from the registered scans of a run (Sec. 4).
struct PlanStudyOptions {
  std::string run;
  PlanStepOptions step;
  slam::SvgOptions svg;
  int width = 1600;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("run", self.run, "directory of a run of `register`, whose scans and poses are taken");
    PlanStepOptions::Visit(self.step, visit);
    visit("svg", self.svg, "how the plan is drawn on paper");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the picture");
  }
};

/// An Error where the run is not there.
void CheckPlanInput(const PlanStudyOptions& options);

/// Writes next_view.json, plan.svg and figures/plan.png; returns what to print.
std::string RunPlan(const PlanStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
