#pragma once

#include "drivers/simulated/load_world.h"
#include "experiments/exploration/scan_loop_world.h"
#include "experiments/metrics/bootstrap.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// The experiment `ablation_nbv_3d`: how view planners explore buildings with the simulated robot, its 3D
/// scans and registration.
struct AblationNbv3dOptions {
  std::string worlds =
      "builtin:robobench, builtin:entrance_hall, $ARIADNE_DATA/plans/school_borchen4_updated.json, "
      "$ARIADNE_DATA/plans/school_franch1_updated.json, $ARIADNE_DATA/plans/school_sabadell3_updated.json, "
      "$ARIADNE_DATA/plans/school_liselotte1_updated.json";
  std::string planners = "default, paper, gain";
  std::string overlaps;
  std::string slices;
  int seeds = 1;
  double target = 0.95;
  int threads = 2;
  Explore3dOptions explore;
  ScanLoopWorldOptions world;
  drivers::WorldOptions geometry;
  BootstrapOptions bootstrap;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("worlds", self.worlds, "what is explored: a, b, ..., each as input.tour.world");
    visit(
        "planners", self.planners,
        "that are compared: `default` is explore.planner, `paper` the constants and the rule of the paper "
        "with the robot's clearances, any other a policy: a, b, ...");
    visit("overlaps", self.overlaps,
          "least overlaps with which the default is tried beside its own; may be empty: a, b, ...");
    visit("slices", self.slices,
          "heights [m] at which the default plans, beside its own: a b c, d e f, ...; may be empty");
    visit("seeds", self.seeds, Unit(""), Range{1, 1000},
          "explorations of each world with each planner; errors of wheels and scanners, and candidates");
    visit("target", self.target, Unit("share"), Range{0.0, 1.0},
          "of the walls, to which scans and way are counted");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "results do not depend on it");
    visit("explore", self.explore, "the exploration");
    visit("world", self.world, "what there is to see");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
    visit("bootstrap", self.bootstrap, "the confidence intervals");
  }
};

/// Error where a list cannot be read, or a world.
void CheckAblationNbv3d(const AblationNbv3dOptions& options);

/// Returns what to print. Each exploration leaves its steps and its drawing, and a line of trials.csv, at
/// once.
std::string RunAblationNbv3d(const AblationNbv3dOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress);

}  // namespace ariadne::experiments
