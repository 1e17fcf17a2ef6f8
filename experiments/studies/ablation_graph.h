#pragma once

#include "experiments/metrics/bootstrap.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "slam/graph/graph_options.h"
#include "slam/graph/simulated_graph.h"

namespace ariadne::experiments {

/// The experiment `ablation_graph`: what robust kernels, starts, noise and size do to pose graphs whose
/// truth is known.
struct AblationGraphOptions {
  slam::SimulatedGraphOptions walk;
  slam::GraphOptions graph;
  std::string wrong_shares = "0, 0.1, 0.2, 0.3, 0.5";
  std::string noise_levels = "0.5, 1, 2, 5, 10";
  std::string sizes = "5, 10, 20, 50, 100, 200";
  int seeds = 50;
  BootstrapOptions bootstrap;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("walk", self.walk, "the simulated graphs, in space");
    visit("graph", self.graph, "how they are optimized, where it is not the subject");
    visit("wrong_shares", self.wrong_shares,
          "shares of wrong closures against which kernels are set: a, b, ...");
    visit("noise_levels", self.noise_levels, "factors on the noise of the walk, for the starts: a, b, ...");
    visit("sizes", self.sizes, "numbers of poses, for the cost: a, b, ...");
    visit("seeds", self.seeds, Unit(""), Range{2, 100000}, "graphs at each level");
    visit("bootstrap", self.bootstrap, "the confidence intervals");
  }
};

/// Error where a list of levels cannot be read.
void CheckAblationGraph(const AblationGraphOptions& options);

/// Returns what to print.
std::string RunAblationGraph(const AblationGraphOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress);

}  // namespace ariadne::experiments
