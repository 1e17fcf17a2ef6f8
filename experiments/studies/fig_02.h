#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/map/octree.h"
#include "slam/map/surface_model.h"

namespace ariadne::experiments {

/// Fig. 2: one 3D scan of a corridor with two persons: its reflectance as measured and as a camera sees it,
/// voxels, lines, surfaces, and the boxes of the objects.
struct Fig02Options {
  InputOptions input = InputOptions::OfTour();
  double field_of_view = 1.4;
  int width = 1000;
  slam::OctreeOptions octree;
  slam::SurfaceModelOptions surfaces;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "the tour; its first scan is taken");
    visit("field_of_view", self.field_of_view, Unit("rad"), Range{0.1, 2.8},
          "across the corrected view; 80 deg are those of a wide-angle lens");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the corrected view");
    visit("octree", self.octree, "the voxels");
    visit("surfaces", self.surfaces, "lines, surfaces and objects");
  }
};

/// Returns what to print.
std::string RunFig02(const Fig02Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
