#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/scan_pair.h"
#include "slam/extract/detect_lines.h"

namespace ariadne::experiments {

/// Fig. 5 of the paper: one scan, its edge points and its reduced points enlarged beside all of its points.
struct Fig05Options {
  InputOptions input;
  slam::ScanFilterOptions scan;
  slam::ReduceOptions reduce{.method = slam::ReduceMethod::kSlices};
  slam::LineOptions lines;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scan; the first is taken");
    visit("scan", self.scan, "which points of a scan are measurements");
    visit("reduce", self.reduce, "how the reduced points are made");
    visit("lines", self.lines, "whose end points are the edge points; the scan must have slices");
  }
};

std::string RunFig05(const Fig05Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
