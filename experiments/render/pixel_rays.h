#pragma once

#include "drivers/simulated/ray_scene.h"
#include "experiments/render/camera.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// The rays through the points of a picture, for pictures that are cast instead of projected.
class PixelRays {
 public:
  /// The camera must live as long.
  explicit PixelRays(const Camera& camera)
      : camera_(camera), T_map_camera_(camera.T_camera_map.Inverse()) {}

  drivers::Ray Through(double u, double v) const {
    const Eigen::Vector2d p = (Eigen::Vector2d(u, v) - camera_.center) / camera_.scale;
    if (camera_.projection == Camera::Projection::kOrthographic) {
      return {T_map_camera_ * Eigen::Vector3d(p.x(), p.y(), -kFarBehind),
              T_map_camera_.rotation * Eigen::Vector3d::UnitZ()};
    }
    return {T_map_camera_.translation,
            (T_map_camera_.rotation * Eigen::Vector3d(p.x(), p.y(), 1.0)).normalized()};
  }

 private:
  static constexpr double kFarBehind = 200.0;  // where the rays of an orthographic camera start [m]

  const Camera& camera_;
  slam::Pose3 T_map_camera_;
};

}  // namespace ariadne::experiments
