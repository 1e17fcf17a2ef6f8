#pragma once

#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// Absolute errors of a trajectory against the truth, both in the coordinates of the first (master) pose,
/// without any alignment: |t - t_true| and the angle of R^T R_true, over all poses but the first.
struct PoseErrors {
  double translation_rms = 0.0;  // [m]
  double translation_max = 0.0;  // [m]
  double rotation_rms = 0.0;     // [rad]
  double rotation_max = 0.0;     // [rad]
};

PoseErrors MeasurePoseErrors(const std::vector<slam::Pose3>& T_map_laser,
                             const std::vector<slam::Pose3>& T_map_laser_true);

}  // namespace ariadne::experiments
