#include "experiments/metrics/pose_error.h"

#include <algorithm>
#include <cmath>

namespace ariadne::experiments {

PoseErrors MeasurePoseErrors(const std::vector<slam::Pose3>& T_map_laser,
                             const std::vector<slam::Pose3>& T_map_laser_true) {
  PoseErrors errors;
  if (T_map_laser.size() < 2) return errors;
  for (std::size_t i = 1; i < T_map_laser.size(); ++i) {
    const slam::Pose3 T_first_laser = T_map_laser.front().Inverse() * T_map_laser[i];
    const slam::Pose3 T_first_true = T_map_laser_true.front().Inverse() * T_map_laser_true[i];
    const double translation = slam::TranslationDistance(T_first_laser, T_first_true);
    const double rotation = slam::RotationDistance(T_first_laser, T_first_true);
    errors.translation_rms += translation * translation;
    errors.rotation_rms += rotation * rotation;
    errors.translation_max = std::max(errors.translation_max, translation);
    errors.rotation_max = std::max(errors.rotation_max, rotation);
  }
  const auto count = static_cast<double>(T_map_laser.size() - 1);
  errors.translation_rms = std::sqrt(errors.translation_rms / count);
  errors.rotation_rms = std::sqrt(errors.rotation_rms / count);
  return errors;
}

}  // namespace ariadne::experiments
