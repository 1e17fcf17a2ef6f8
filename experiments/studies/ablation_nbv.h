#pragma once

#include "experiments/metrics/bootstrap.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/nbv_trials.h"

namespace ariadne::experiments {

/// The experiment `ablation_nbv`: policies and parameters of the view planner on floors that are known
/// exactly, with exact visibility in the plane, against the fewest views that would do.
struct AblationNbvOptions {
  std::string floors = "plans, builtin:robobench, builtin:entrance_hall";
  std::string studies =
      "policies, gain, samplers, ways, candidates, c1, c2, rest, least_share, field_of_view, min_overlap";
  std::string variants = "all";
  std::string bounds_of;
  int seeds = 10;
  int first_seed = 1;
  int policy_seeds = 10;
  int study_seeds = 3;
  double share = 0.95;
  ExploreOptions explore;
  NbvFloorOptions floor;
  BootstrapOptions bootstrap;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("floors", self.floors,
          "a, b, ...: worlds as simulate takes them; plans: all in $ARIADNE_DATA/plans");
    visit("studies", self.studies, "a, b, ...: what is varied, one after another; policies comes first");
    visit("variants", self.variants, "a, b, ...: only these of the studies, and default; all: each");
    visit("bounds_of", self.bounds_of,
          "run directory of this experiment whose fewest views are taken where it has a floor; empty: they "
          "are searched for, a minute on a large floor");
    visit("seeds", self.seeds, Unit(""), Range{1, 10000}, "starts on each floor, for `default`");
    visit("first_seed", self.first_seed, Unit(""), Range{1, 1000000},
          "1 begins where a floor's file says, others anywhere; what is calibrated needs others than what "
          "judges it");
    visit(
        "policy_seeds", self.policy_seeds, Unit(""), Range{1, 10000},
        "for the other policies, of the same; no more than for the default, which they are compared with");
    visit("study_seeds", self.study_seeds, Unit(""), Range{1, 10000}, "for all other studies, likewise");
    visit("share", self.share, Unit("share"), Range{0.01, 1.0},
          "of what can be seen, to which scans and ways are counted; of the bound too");
    visit("explore", self.explore, "the planner where it is not varied: `default` in the tables");
    visit("floor", self.floor, "what is to be seen, and the bound");
    visit("bootstrap", self.bootstrap, "the confidence intervals, over floors");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "the result does not depend on it");
  }
};

/// Error for a floor, a study or a list that there is not.
void CheckAblationNbv(const AblationNbvOptions& options);

/// Returns what to print. Trials are written floor by floor.
std::string RunAblationNbv(const AblationNbvOptions& options, const RunDirectory& run,
                           ProgressDisplay& progress);

}  // namespace ariadne::experiments
