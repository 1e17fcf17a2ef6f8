#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/map/surface_model.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// The experiment `extract`: lines, edge points, surfaces and objects of each scan by itself (Sec. 2.2.1).
struct ExtractOptions {
  InputOptions input;
  slam::ScanFilterOptions scan;
  slam::SurfaceModelOptions surfaces;
  bool figures = true;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scans");
    visit("scan", self.scan, "which points of a scan are measurements");
    visit("surfaces", self.surfaces, "lines, surfaces and objects");
    visit("figures", self.figures, "draw the surfaces and objects of each scan");
  }
};

/// Returns what to print.
std::string RunExtract(const ExtractOptions& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
