#pragma once

#include "slam/base/options.h"

namespace ariadne::slam {

/// Which program makes the objective small.
enum class GraphSolver {
  kGaussNewton,  // our own, on CHOLMOD: for relative poses and priors
  kCeres,        // Ceres: for every factor
};

/// From which poses it starts.
enum class GraphStart {
  kAuto,     // kChordal; kOdometry where edges may be wrong, all of which the chords would take for right
  kChordal,  // rotations and translations by two linear systems; the nodes' poses are not looked at
  kGuess,    // the nodes' poses
  kOdometry  // the measurements along a spanning tree, edges between successive nodes first
};

/// What keeps wrong edges from bending the map. Edges between successive nodes are trusted.
enum class GraphRobust {
  kNone,
  kHuber,
  kCauchy,
  kGemanMcClure,
  kDcs,         // dynamic covariance scaling
  kSwitchable,  // switchable constraints: a variable per edge that can turn it off (Ceres)
  kGnc          // graduated non-convexity with truncated least squares: an edge is in or out
};

struct GraphOptions {
  GraphSolver solver = GraphSolver::kGaussNewton;
  GraphStart start = GraphStart::kAuto;
  GraphRobust robust = GraphRobust::kNone;
  double robust_confidence = 0.99;
  double switch_weight = 4.0;
  int max_iterations = 100;
  double convergence = 1e-6;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "solver", self.solver,
        "gauss_newton is the faster one, and the one that gnc runs on; switchable runs on ceres; both end "
        "in the same minimum");
    visit(
        "start", self.start,
        "chordal escapes the local minima of the others, but takes every edge for right; auto is chordal, "
        "or odometry where robust is not none");
    visit("robust", self.robust,
          "how wrong closures are kept from bending the map; gnc stands the largest share of them");
    visit("robust_confidence", self.robust_confidence, Unit(""), Range{0.5, 0.999999},
          "share of right edges that the kernel leaves (nearly) alone, by chi-square");
    visit("switch_weight", self.switch_weight, Unit(""), Range{1e-6, 1e6},
          "of switchable: an edge with a larger error, in sigmas, is turned off; 4 is the root of the 99 % "
          "quantile in space");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 100000}, "of each descent");
    visit("convergence", self.convergence, Unit(""), Range{0.0, 1.0},
          "ends with the step that promises to lower the objective by a smaller share; as convergence is "
          "quadratic, what then remains to gain is far less");
  }
};

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::GraphSolver> {
  static constexpr std::array<std::string_view, 2> value{"gauss_newton", "ceres"};
};
template <>
struct EnumNames<slam::GraphStart> {
  static constexpr std::array<std::string_view, 4> value{"auto", "chordal", "guess", "odometry"};
};
template <>
struct EnumNames<slam::GraphRobust> {
  static constexpr std::array<std::string_view, 7> value{"none", "huber",      "cauchy", "geman_mcclure",
                                                         "dcs",  "switchable", "gnc"};
};

}  // namespace ariadne
