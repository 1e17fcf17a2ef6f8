#pragma once

#include <array>

#include "slam/base/options.h"

namespace ariadne::slam {

/// What Align() makes small, for paired points m (model) and T d (data).
enum class Metric {
  kPointToPoint,  // |m - T d|^2, in closed form (Sec. 3.1)
  kPointToPlane,  // (n_m . (m - T d))^2
  kPlaneToPlane,  // generalized ICP: both points lie on planes of their own
};

/// How pairs are found; the pairs are the same.
enum class Search { kKdTree, kBruteForce };

/// The closed form of the point-to-point metric; the minimum is the same.
enum class ClosedForm { kQuaternion, kSvd };

/// How strongly a pair counts, by its residual r and the scale s.
enum class RobustKernel { kNone, kHuber, kCauchy, kTukey, kGemanMcClure };

struct AlignOptions {
  Metric metric = Metric::kPointToPoint;
  Search search = Search::kKdTree;
  ClosedForm closed_form = ClosedForm::kQuaternion;
  double search_radius = 0.0;
  double max_distance = 0.5;
  double start_distance = 0.0;
  double shrink = 0.8;
  double guess_share = 0.0;
  double trim = 1.0;
  RobustKernel kernel = RobustKernel::kNone;
  double kernel_scale = 0.0;
  bool skip_boundary = false;
  bool one_sided = false;
  int max_iterations = 200;
  double convergence_rms = 1e-7;
  double convergence_step = 0.0;
  int min_pairs = 10;
  int normal_neighbors = 10;
  double min_observability = 0.01;
  bool assess = true;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("metric", self.metric,
          "point_to_point is the paper's (3.1); the others converge faster where surfaces are smooth");
    visit("search", self.search, "brute_force is the reference of Table 1; both find identical pairs");
    visit("closed_form", self.closed_form,
          "of point_to_point: Horn's quaternion (3.1), or the SVD as a check");
    visit("search_radius", self.search_radius, Unit("m"), Range{0.0, 100.0},
          "try starts all around the guess, within this radius, and refine the best; 0: only the guess "
          "(3.1)");
    visit("max_distance", self.max_distance, Unit("m"), Range{1e-4, 1e3},
          "gate of a pair; open in the paper, later work needs one since scans overlap only in part");
    visit("start_distance", self.start_distance, Unit("m"), Range{0.0, 1e3},
          "gate of the first iteration, for a poor guess; 0: max_distance throughout");
    visit("shrink", self.shrink, Unit(""), Range{0.1, 0.99},
          "factor per iteration from start_distance down to max_distance");
    visit("guess_share", self.guess_share, Unit(""), Range{0.0, 1.0},
          "the guess counts as much as this share of the pairs: directions that the surfaces hardly hold "
          "stay where it has them, and wrong pairs do not carry the data away; 0: only a start (3.1)");
    visit("trim", self.trim, Unit(""), Range{0.05, 1.0},
          "share of the pairs, the closest ones, that counts");
    visit("kernel", self.kernel,
          "weight of a pair by its residual, once the gate is down at max_distance; the paper weighs all "
          "alike");
    visit("kernel_scale", self.kernel_scale, Unit("m"), Range{0.0, 1e2},
          "residual at which the kernel sets in; 0: three robust sigmas of the residuals, each iteration");
    visit("skip_boundary", self.skip_boundary,
          "drop pairs with model points where the model's scan ends: what lies beyond pairs wrongly with "
          "them");
    visit("one_sided", self.one_sided,
          "drop pairs of points that were seen from opposite sides, as those of a wall thinner than the "
          "gate; "
          "for clouds in the frames of their scanners");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 100000},
          "Table 1 took 25 to 27; the real hallway takes up to 64 to its last digit");
    visit(
        "convergence_rms", self.convergence_rms, Unit("m"), Range{0.0, 1.0},
        "stop when the rms differs by less from each of the last two; open in the paper, 1e-5 cm as 3DTK");
    visit("convergence_step", self.convergence_step, Unit("m, rad"), Range{0.0, 1.0},
          "stop when a step is shorter in translation and rotation; 0: off");
    visit("min_pairs", self.min_pairs, Unit(""), Range{3, 1e9},
          "fewer pairs are no registration; three fix a pose, but no error of it");
    visit("normal_neighbors", self.normal_neighbors, Unit(""), Range{3, 64},
          "points to which the surface at a point is fitted");
    visit(
        "min_observability", self.min_observability, Unit(""), Range{0.0, 1.0},
        "share of the pairs that must notice each direction of motion, or the result is called degenerate");
    visit("assess", self.assess, "estimate the covariance and the directions that nothing holds");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "the result does not depend on it");
  }
};

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::Metric> {
  static constexpr std::array<std::string_view, 3> value{"point_to_point", "point_to_plane",
                                                         "plane_to_plane"};
};
template <>
struct EnumNames<slam::Search> {
  static constexpr std::array<std::string_view, 2> value{"kd_tree", "brute_force"};
};
template <>
struct EnumNames<slam::ClosedForm> {
  static constexpr std::array<std::string_view, 2> value{"quaternion", "svd"};
};
template <>
struct EnumNames<slam::RobustKernel> {
  static constexpr std::array<std::string_view, 5> value{"none", "huber", "cauchy", "tukey",
                                                         "geman_mcclure"};
};

}  // namespace ariadne
