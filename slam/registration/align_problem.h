#pragma once

#include <Eigen/Core>

#include "slam/base/parallel.h"
#include "slam/registration/align.h"
#include "slam/registration/correspondence_tracker.h"
#include "slam/registration/gauss_newton.h"
#include "slam/registration/guess_pairs.h"
#include "slam/registration/pair_weight.h"
#include "slam/registration/rigid_fit.h"

namespace ariadne::slam {

/// What one iteration makes of the pairs at a pose.
struct Improvement {
  Pose3 T_model_data;
  std::size_t pairs = 0;  // that count
  double rms = 0.0;       // of their residuals before the step, by the metric [m]
  bool unique = true;     // false where the pairs leave the pose open
};

/// Two clouds under one metric: the part of Align() that looks at points. Refers to its arguments.
class AlignProblem {
 public:
  AlignProblem(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
               const AlignOptions& options);

  /// Pairs the points at a pose, and finds the pose (point-to-point) or the Gauss-Newton step (planes) that
  /// makes the error of these pairs small.
  Improvement Improve(const Pose3& T_model_data, double max_distance);

  /// How good the pose is to which the last pairs have led.
  Assessment Assess(const Pose3& T_model_data) const;

 private:
  void FindPairs(const Pose3& T_model_data, double max_distance);
  void DropUnusablePairs(const Pose3& T_model_data);
  void ChooseWeights(const Pose3& T_model_data, bool with_kernel);
  /// The same with the guess, which counts as a share of the pairs.
  PairMoments HoldToGuess(PairMoments moments) const;
  void HoldToGuess(const Pose3& T_model_data, NormalEquations& equations) const;
  Improvement FitPoints() const;
  Improvement StepToPlanes(const Pose3& T_model_data) const;

  const AlignModel& model_;
  const AlignData& data_;
  const AlignOptions& options_;
  Parallel parallel_;
  CorrespondenceTracker tracker_;
  Correspondences own_pairs_;               // where they are not the tracker's
  const Correspondences* pairs_ = nullptr;  // at the last pose
  PairWeight weight_;
  Eigen::Vector3d center_model_;
  Eigen::Vector3d center_data_;
  double length_;  // makes rotations comparable with translations [m]
  GuessPairs guess_;
};

}  // namespace ariadne::slam
