#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// Fig. 4: many scans of a corridor from above, by each way of matching.
struct Fig04Options {
  InputOptions input = InputOptions::OfTour();
  slam::MapperOptions mapper;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "the tour");
    slam::MapperOptions::Visit(self.mapper, visit);
    visit("threads", self.threads, Unit(""), Range{1, 1024},
          "of the metrics; the result does not depend on it");
  }
};

/// Returns what to print.
std::string RunFig04(const Fig04Options& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
