#pragma once

#include <string>

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "slam/graph/graph_options.h"

namespace ariadne::experiments {

/// The experiment `posegraph_benchmark`: every graph of a folder, all with the same options.
struct PosegraphBenchmarkOptions {
  std::string folder = "$ARIADNE_DATA/graphs";
  slam::GraphOptions graph;
  std::string optima =
      "sphere2500 1687.005810, torus3D 24227.0456, parking-garage 1.262524, cubicle 717.125991, "
      "smallGrid3D 1025.398060, intel 52.348227, MIT 61.154116, manhattan 6431.391390, kitti_00 125.693515";
  double tolerance = 1e-6;
  bool from_guess = true;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("folder", self.folder, "of .g2o files; $ARIADNE_DATA in it stands for the environment's");
    visit("graph", self.graph, "how they are optimized");
    visit("optima", self.optima,
          "known minima of the isotropic objective by the files' names, as SE-Sync has certified them");
    visit(
        "tolerance", self.tolerance, Unit(""), Range{0.0, 1.0},
        "by which share the objective may differ from the known one; they are given with 7 digits or more");
    visit("from_guess", self.from_guess, "show also where a start from the file's own poses ends");
  }
};

/// How the benchmark has ended.
struct PosegraphBenchmarkSummary {
  std::string text;     // to print
  std::string problem;  // which known optima were missed, or not certified; else empty
};

/// Error where the folder holds no graphs or the known optima cannot be read.
void CheckPosegraphBenchmark(const PosegraphBenchmarkOptions& options);

/// Fills graphs.csv, metrics.json and timing.json.
PosegraphBenchmarkSummary RunPosegraphBenchmark(const PosegraphBenchmarkOptions& options,
                                                const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
