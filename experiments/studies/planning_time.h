#pragma once

#include <string>

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "planning/view/view_planner.h"

namespace ariadne::experiments {

/// How long it takes to choose the next view, over candidates and over edges (Sec. 4.2: up to 2 s in 2003).
struct PlanningTimeOptions {
  std::string candidates = "50, 100, 200, 400, 800";
  std::string edges = "100, 300, 1000, 3000, 10000";
  int usual_candidates = 200;
  int usual_edges = 1000;
  int decisions = 200;
  double median_limit = 20.0;
  double quantile_limit = 50.0;
  planning::ViewPlannerOptions planner;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("candidates", self.candidates, "a, b, ...: with usual_edges");
    visit("edges", self.edges, "a, b, ...: about as many, with usual_candidates");
    visit("usual_candidates", self.usual_candidates, Unit(""), Range{1, 100000},
          "what is held against the limits; further ones around the best (planner.refined) come on top");
    visit("usual_edges", self.usual_edges, Unit(""), Range{4, 100000}, "likewise");
    visit("decisions", self.decisions, Unit(""), Range{2, 100000},
          "for each number, from places all over the building");
    visit("median_limit", self.median_limit, Unit("ms"), Range{1e-6, 1e9}, "for the usual numbers");
    visit("quantile_limit", self.quantile_limit, Unit("ms"), Range{1e-6, 1e9},
          "for 99 % of the decisions with the usual numbers");
    visit("planner", self.planner, "the planner that is measured; its number of candidates is varied");
  }
};

/// Error for a list that holds anything but numbers.
void CheckPlanningTime(const PlanningTimeOptions& options);

/// Returns what to print: times are the one result that differs from run to run.
std::string RunPlanningTime(const PlanningTimeOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress);

}  // namespace ariadne::experiments
