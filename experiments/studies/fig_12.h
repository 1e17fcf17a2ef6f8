#pragma once

#include "experiments/render/image.h"
#include "experiments/studies/explored_run.h"

namespace ariadne::experiments {

/// Fig. 12: an exploration: its path with numbered stops, the mesh, and views with boxes around objects.
struct Fig12Options {
  ExploredRunOptions exploration;
  ModelOptions model;
  int width = 1600;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    ExploredRunOptions::Visit(self.exploration, visit);
    visit("model", self.model, "mesh and boxes of the figure");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the picture");
  }
};

/// Error where there is nothing to show.
void CheckFig12(const Fig12Options& options);

/// Returns what to print.
std::string RunFig12(const Fig12Options& options, const RunDirectory& run, ProgressDisplay& progress);

/// From above: what stands between floor and ceiling as ink, the way that was driven, and the stops,
/// counted from 1. `width` in pixels; as high as it needs.
Image PathPicture(const ExploredRun& explored, int width);

}  // namespace ariadne::experiments
