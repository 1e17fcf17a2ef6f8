#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/scan_pair.h"

namespace ariadne::experiments {

/// Fig. 3 of the paper: two scans before, during and after ICP.
struct Fig03Options : ScanPairOptions {
  int iterations = 5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    ScanPairOptions::Visit(self, visit);
    visit("iterations", self.iterations, Unit(""), Range{1, 1e6},
          "of the picture in the middle; 5 in the paper");
  }
};

/// Draws both scans at the three poses, from above and at an angle; returns a sentence on each pose.
std::string RunFig03(const Fig03Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
