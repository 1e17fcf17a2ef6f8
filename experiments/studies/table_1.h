#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/scan_pair.h"

namespace ariadne::experiments {

/// Table 1 of the paper: time and iterations of ICP with all and with reduced points, by brute force and by
/// k-d tree.
struct Table1Options : ScanPairOptions {
  int repeats = 5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    ScanPairOptions::Visit(self, visit);
    visit("repeats", self.repeats, Unit(""), Range{1, 1000},
          "of each measurement by k-d tree, whose median counts; brute force is measured once");
  }
};

/// Fills metrics.json and timing.json; returns the table to print.
std::string RunTable1(const Table1Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
