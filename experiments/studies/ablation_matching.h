#pragma once

#include "experiments/metrics/bootstrap.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// The experiment `ablation_matching`: the ways of matching many scans against each other, on simulated
/// tours with a known truth, at several levels of odometry noise and with many seeds.
struct AblationMatchingOptions {
  InputOptions input = InputOptions::OfTour();
  slam::MapperOptions mapper;
  std::string methods = "pairwise, metascan, edges, simultaneous, graph, joint";
  std::string noise_levels = "0.5, 1, 2, 4";
  int seeds = 30;
  BootstrapOptions bootstrap;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "the tour; its odometry_noise is set by the levels, its seed is the first");
    slam::MapperOptions::Visit(self.mapper, visit);
    visit("methods", self.methods,
          "a, b, ...: those of registration.method, and edges; simultaneous among them");
    visit("noise_levels", self.noise_levels, "factors on the errors of the wheels: a, b, ...");
    visit("seeds", self.seeds, Unit(""), Range{2, 10000},
          "tours at each level; 30 give medians their intervals");
    visit("bootstrap", self.bootstrap, "the confidence intervals");
    visit("threads", self.threads, Unit(""), Range{1, 1024},
          "of the metrics; the result does not depend on it");
  }
};

/// Returns what to print. Interrupted runs go on at the tour that they were at.
std::string RunAblationMatching(const AblationMatchingOptions& options, const RunDirectory& run,
                                ProgressDisplay& progress);

}  // namespace ariadne::experiments
