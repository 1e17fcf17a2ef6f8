#include "experiments/metrics/trajectory_error.h"

#include "slam/base/error.h"
#include "slam/registration/rigid_fit.h"

namespace ariadne::experiments {
namespace {

void RequirePairs(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true) {
  if (T_map_laser.size() != T_map_laser_true.size()) {
    Fail("a trajectory of {} poses cannot be compared with a true one of {}", T_map_laser.size(),
         T_map_laser_true.size());
  }
}

/// Gathers the errors between poses.
class ErrorList {
 public:
  void Add(const slam::Pose3& estimated, const slam::Pose3& truth) {
    translations_.push_back(slam::TranslationDistance(estimated, truth));
    rotations_.push_back(slam::RotationDistance(estimated, truth));
  }
  TrajectoryError Result() const { return {Summarize(translations_), Summarize(rotations_)}; }

 private:
  std::vector<double> translations_;  // [m]
  std::vector<double> rotations_;     // [rad]
};

/// The rigid motion that brings the positions closest to the true ones.
slam::RigidFit AlignPositions(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true) {
  const Eigen::Vector3d origin_true = T_map_laser_true.front().translation;
  const Eigen::Vector3d origin_map = T_map_laser.front().translation;
  slam::PairMoments moments;
  for (std::size_t k = 0; k < T_map_laser.size(); ++k) {
    moments.Add(T_map_laser_true[k].translation - origin_true, T_map_laser[k].translation - origin_map, 1.0,
                0.0);
  }
  slam::RigidFit fit = slam::FitByQuaternion(moments);
  fit.T_model_data.translation += origin_true - fit.T_model_data.rotation * origin_map;
  return fit;
}

}  // namespace

TrajectoryError ErrorFromMaster(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true) {
  RequirePairs(T_map_laser, T_map_laser_true);
  ErrorList errors;
  for (std::size_t k = 1; k < T_map_laser.size(); ++k) {
    errors.Add(T_map_laser.front().Inverse() * T_map_laser[k],
               T_map_laser_true.front().Inverse() * T_map_laser_true[k]);
  }
  return errors.Result();
}

AlignedError ErrorAligned(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true) {
  RequirePairs(T_map_laser, T_map_laser_true);
  if (T_map_laser.empty()) return {};
  const slam::RigidFit fit = AlignPositions(T_map_laser, T_map_laser_true);
  ErrorList errors;
  for (std::size_t k = 0; k < T_map_laser.size(); ++k)
    errors.Add(fit.T_model_data * T_map_laser[k], T_map_laser_true[k]);
  return {errors.Result(), fit.T_model_data, fit.unique};
}

TrajectoryError ErrorRelative(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true,
                              const RelativeErrorOptions& options) {
  RequirePairs(T_map_laser, T_map_laser_true);
  if (options.delta == 0) Fail("a relative error is between two poses: delta must be at least 1");
  ErrorList errors;
  const std::size_t step = options.all_pairs ? 1 : options.delta;
  for (std::size_t i = 0; i + options.delta < T_map_laser.size(); i += step) {
    const std::size_t j = i + options.delta;
    errors.Add(T_map_laser[i].Inverse() * T_map_laser[j],
               T_map_laser_true[i].Inverse() * T_map_laser_true[j]);
  }
  return errors.Result();
}

PathStatistics MeasurePath(const Trajectory& T_map_laser) {
  PathStatistics path{T_map_laser.size()};
  for (std::size_t k = 1; k < T_map_laser.size(); ++k) {
    path.length += slam::TranslationDistance(T_map_laser[k - 1], T_map_laser[k]);
    path.turned += slam::RotationDistance(T_map_laser[k - 1], T_map_laser[k]);
  }
  return path;
}

}  // namespace ariadne::experiments
