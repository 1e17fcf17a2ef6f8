#pragma once

#include "drivers/simulated/ais_scanner_options.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "slam/extract/extract_surfaces.h"

namespace ariadne::experiments {

/// The experiment `ablation_features`: detectors of lines and surfaces against the truth of simulated
/// rooms, and against themselves on real sweeps.
struct AblationFeaturesOptions {
  int line_rooms = 200;
  int surface_rooms = 50;
  int seed = 1;
  drivers::AisScannerOptions scanner;
  slam::ExtractSurfacesOptions detect;
  std::string logs = "$ARIADNE_DATA/sweeps2d/fr079.clf.bz2, $ARIADNE_DATA/sweeps2d/intel.clf.bz2";
  int log_every = 10;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("line_rooms", self.line_rooms, Unit(""), Range{1, 100000},
          "random rooms in which level slices are taken");
    visit("surface_rooms", self.surface_rooms, Unit(""), Range{1, 100000},
          "random rooms in which 3D scans are taken");
    visit("seed", self.seed, Unit(""), Range{0, 2147483647}, "of the first room; tests have others");
    visit("scanner", self.scanner, "the simulated scanner with its errors");
    visit("detect", self.detect, "the detectors; their methods are those that are compared");
    visit("logs", self.logs, "CARMEN logs of real sweeps: a, b, ...; those that are missing are left out");
    visit("log_every", self.log_every, Unit("sweeps"), Range{1, 1000000},
          "one pair of successive sweeps in so many is looked at");
  }
};

/// Returns what to print.
std::string RunAblationFeatures(const AblationFeaturesOptions& options, const RunDirectory& run,
                                ProgressDisplay& progress);

}  // namespace ariadne::experiments
