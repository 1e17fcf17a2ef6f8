#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/map/octree.h"

namespace ariadne::experiments {

/// Fig. 11: the octree of a scan at several depths, as cubes.
struct Fig11Options {
  InputOptions input = InputOptions::OfTour();
  slam::OctreeOptions octree;
  std::string depths = "1, 3, 5, 6, 7, 8";
  int width = 900;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scan; the first is taken");
    visit("octree", self.octree, "how fine the leaves are");
    visit("depths", self.depths, "of the pictures: a, b, ...; the paper's are 1, 3, 5 to 8");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of each picture");
  }
};

/// Returns what to print.
std::string RunFig11(const Fig11Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
