#pragma once

#include "experiments/studies/explored_run.h"

namespace ariadne::experiments {

/// Fig. 13: the first scans of an exploration, each by its distorted reflectance image and the polygon that
/// it was planned in, with the trajectory to the next; and the boxes around objects in colours.
struct Fig13Options {
  ExploredRunOptions exploration;
  ModelOptions model;
  int scans = 9;
  int width = 540;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    ExploredRunOptions::Visit(self.exploration, visit);
    visit("model", self.model, "mesh and boxes of the figure");
    visit("scans", self.scans, Unit(""), Range{1, 1000}, "that are shown; nine in the paper");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the panel of a scan");
  }
};

/// Error where there is nothing to show.
void CheckFig13(const Fig13Options& options);

/// Returns what to print.
std::string RunFig13(const Fig13Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
