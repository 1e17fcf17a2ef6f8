#pragma once

#include <span>

#include "slam/geometry/pose2.h"
#include "slam/registration/align.h"

namespace ariadne::slam {

struct LocateOptions {
  double max_distance = 0.3;
  double sigma = 0.03;
  double independent = 0.2;
  double min_matched = 0.3;
  int max_iterations = 15;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_distance", self.max_distance, Unit("m"), Range{0.01, 10.0},
          "gate of a pair, halved towards the end; above what odometry errs between two sweeps");
    visit("sigma", self.sigma, Unit("m"), Range{1e-4, 1.0},
          "of a beam's distance from the map's surface, and scale of the kernel (Cauchy): scanner, map and "
          "motion");
    visit("independent", self.independent, Unit("share"), Range{1e-3, 1.0},
          "of the pairs that count as independent: those of one wall err alike");
    visit("min_matched", self.min_matched, Unit("share"), Range{0.0, 1.0},
          "of the beams that find the map, or the sweep says nothing");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 1000}, "of Gauss-Newton");
  }
};

struct LocateResult {
  bool trusted = false;  // enough beams have found the map, and the pose has settled
  Pose2 T_map_base;      // where not trusted: the guess
  Pose2::Square covariance = Pose2::Square::Zero();  // in the tangent space of the pose
  double matched = 0.0;                              // share of the beams
};

/// Where a robot is, from one horizontal sweep against the map's surfaces: point to plane in the plane,
/// with the guess as prior. What no wall holds, as the way along a corridor, stays as guessed. Surfaces
/// count from the side from which they were seen, so that a thin wall is not taken for its back.
///
/// `points_base` are the sweep's returns, at the height of the scanner; `model_map` has surfaces. The
/// covariance is the guess's, in its tangent space; it must be positive definite.
LocateResult LocateSweep(const AlignModel& model_map, std::span<const Eigen::Vector3d> points_base,
                         const Pose2& T_map_base_guess, const Pose2::Square& covariance,
                         const LocateOptions& options);

}  // namespace ariadne::slam
