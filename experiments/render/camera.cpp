#include "experiments/render/camera.h"

#include <cmath>
#include <numbers>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// The camera's pose at an eye, its z axis along `ahead` and `up` upwards in the picture.
slam::Pose3 CameraPose(const Eigen::Vector3d& eye_map, const Eigen::Vector3d& ahead,
                       const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = ahead.cross(up);
  if (!(right.norm() > 1e-9 * ahead.norm() * up.norm()) || !right.allFinite()) {
    Fail("a camera at ({}, {}, {}) has no direction: it looks at its own place or along its up vector",
         eye_map.x(), eye_map.y(), eye_map.z());
  }
  Eigen::Matrix3d R_camera_map;
  R_camera_map.row(0) = right.normalized();
  R_camera_map.row(1) = ahead.cross(right).normalized();
  R_camera_map.row(2) = ahead.normalized();
  return {Eigen::Quaterniond(R_camera_map), -R_camera_map * eye_map};
}

Camera SizedCamera(Camera::Projection projection, const PictureSize& size, double scale) {
  Camera camera{.projection = projection, .scale = scale, .width = size.width, .height = size.height};
  camera.center = {0.5 * size.width, 0.5 * size.height};
  return camera;
}

/// The focal length [px] at which the width spans the field of view.
double FocalLength(double field_of_view, const PictureSize& size) {
  if (!(field_of_view > 0.0 && field_of_view < std::numbers::pi)) {
    Fail("the field of view of a camera must lie between 0 and pi rad, not {}", field_of_view);
  }
  return 0.5 * size.width / std::tan(0.5 * field_of_view);
}

}  // namespace

Projector::Projector(const Camera& camera)
    : R_(camera.T_camera_map.RotationMatrix()),
      t_(camera.T_camera_map.translation),
      center_(camera.center),
      scale_(camera.scale),
      is_perspective_(camera.projection == Camera::Projection::kPerspective) {
  RequireUsable(camera);
}

Camera TopView(const PictureSize& size, Up up, const Eigen::Vector3d& target_map, double scale) {
  Camera camera = SizedCamera(Camera::Projection::kOrthographic, size, scale);
  const Eigen::Vector3d up_map = up == Up::kPlusX ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  camera.T_camera_map = CameraPose(target_map, -Eigen::Vector3d::UnitZ(), up_map);
  return camera;
}

Camera ObliqueView(const Eigen::Vector3d& target_map, const ObliqueOptions& options) {
  const double focal = FocalLength(options.field_of_view, options.size);
  const bool is_perspective = options.projection == Camera::Projection::kPerspective;
  // An orthographic picture shows the target at the size that the perspective one would.
  Camera camera =
      SizedCamera(options.projection, options.size, is_perspective ? focal : focal / options.distance);
  const Eigen::Vector3d to_eye(std::cos(options.elevation) * std::cos(options.azimuth),
                               std::cos(options.elevation) * std::sin(options.azimuth),
                               std::sin(options.elevation));
  camera.T_camera_map =
      CameraPose(target_map + options.distance * to_eye, -to_eye, Eigen::Vector3d::UnitZ());
  return camera;
}

Camera LookAt(const Eigen::Vector3d& eye_map, const Eigen::Vector3d& target_map,
              const Eigen::Vector3d& up_map, double field_of_view, const PictureSize& size) {
  Camera camera = SizedCamera(Camera::Projection::kPerspective, size, FocalLength(field_of_view, size));
  camera.T_camera_map = CameraPose(eye_map, target_map - eye_map, up_map);
  return camera;
}

Camera Magnified(Camera camera, int factor) {
  camera.scale *= factor;
  camera.width *= factor;
  camera.height *= factor;
  camera.center *= factor;
  return camera;
}

void RequireUsable(const Camera& camera) {
  const bool is_finite = slam::IsFinite(camera.T_camera_map) && camera.center.allFinite();
  if (!is_finite) Fail("the pose of the camera of a picture is not finite");
  if (!(camera.scale > 0.0) || !std::isfinite(camera.scale)) {
    Fail("the scale of the camera of a picture must be positive, not {}", camera.scale);
  }
  if (camera.width < 1 || camera.height < 1) {
    Fail("a camera cannot make a picture of {} x {} pixels", camera.width, camera.height);
  }
}

}  // namespace ariadne::experiments
