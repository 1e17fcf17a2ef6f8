#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "slam/geometry/pose3.h"
#include "slam/registration/observability.h"
#include "slam/registration/options.h"
#include "slam/scan/point_cloud.h"
#include "slam/search/kd_tree.h"
#include "slam/search/surface.h"

namespace ariadne::slam {

/// How an alignment ended. Only kConverged is a success.
enum class AlignStatus {
  kConverged,
  kDegenerate,      // converged, but the surfaces leave some direction of motion (almost) free
  kIterationLimit,  // max_iterations were not enough
  kTooFewPairs,     // fewer than min_pairs within the gate
  kNotUnique,       // the pairs lie on one line, or in one point
  kBadInput,        // an empty cloud, or a coordinate that is not a number
};

std::string_view Name(AlignStatus status);

/// One iteration: the pairs at its start, and the step that they asked for.
struct AlignIteration {
  double max_distance = 0.0;  // the gate [m]
  std::size_t pairs = 0;
  double rms = 0.0;               // of the metric's residual over the pairs that count [m]
  double step_translation = 0.0;  // [m]
  double step_rotation = 0.0;     // [rad]
};

/// How far the result can be trusted.
struct Assessment {
  Observability observability;
  Pose3::Square covariance = Pose3::Square::Zero();  // of T_model_data, in the tangent space of Pose3
};

struct AlignResult {
  AlignStatus status = AlignStatus::kBadInput;
  std::string message;  // the status as a sentence, with numbers
  Pose3 T_model_data;   // where status is no success: how far it came
  std::vector<AlignIteration> iterations;
  std::size_t pairs = 0;                 // of the last iteration
  double rms = 0.0;                      // of the last iteration [m]
  double overlap = 0.0;                  // share of the data points that have a pair
  std::optional<Assessment> assessment;  // of a converged alignment, if options.assess

  bool converged() const { return status == AlignStatus::kConverged; }
};

/// The fixed cloud with what searching in it needs; prepared once, used for many alignments.
struct AlignModel {
  KdTree tree;
  std::vector<SurfacePoint> surfaces;  // one per point, or empty where neither metric nor filter needs them
};

/// Whether the metric or a filter looks at the surfaces of the model, or of the data.
bool NeedsModelSurfaces(const AlignOptions& options);
bool NeedsDataSurfaces(const AlignOptions& options);

/// Throws an Error for an empty cloud, a point that is not finite, or an option out of its range.
AlignModel PrepareModel(const PointCloud& model, const AlignOptions& options);

/// The moving cloud with what the metric and the filters need.
struct AlignData {
  std::vector<Eigen::Vector3d> points;
  std::vector<SurfacePoint> surfaces;  // one per point, or empty where neither metric nor filter needs them
};

AlignData PrepareData(const PointCloud& data, const AlignOptions& options);

/// Iterative closest points (Sec. 3.1): moves data onto model, starting from a guess, which with
/// guess_share also counts beside the pairs. `on_iteration`, if given, is called after each iteration.
AlignResult Align(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
                  const AlignOptions& options,
                  const std::function<void(const AlignIteration&)>& on_iteration = {});

/// The same from the clouds; hopeless clouds are told by the status, not by an exception.
AlignResult Align(const PointCloud& model, const PointCloud& data, const Pose3& T_model_data_guess,
                  const AlignOptions& options);

}  // namespace ariadne::slam
