#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// A camera without distortion. Frame `camera`: x to the right of the picture, y down, z ahead.
struct Camera {
  enum class Projection { kOrthographic, kPerspective };

  Projection projection = Projection::kOrthographic;
  slam::Pose3 T_camera_map = {};
  double scale = 50.0;  // orthographic: pixels per metre; perspective: focal length [px]
  int width = 1600;     // of the picture [px]
  int height = 1200;    // [px]
  Eigen::Vector2d center = {800.0, 600.0};  // where the camera's z axis meets the picture [px]
};

/// Where a point appears.
struct ImagePoint {
  double u = 0.0;      // to the right [px], see Image for the centres of pixels
  double v = 0.0;      // down [px]
  double depth = 0.0;  // along the camera's z [m]
};

/// Perspective cameras see what lies further ahead than this. [m]
inline constexpr double kNearestDepth = 0.05;

/// Projects points of the map; made once per picture because it holds the camera as a matrix.
class Projector {
 public:
  explicit Projector(const Camera& camera);

  Eigen::Vector3d ToCamera(const Eigen::Vector3d& p_map) const { return R_ * p_map + t_; }
  ImagePoint FromCamera(const Eigen::Vector3d& p_camera) const {
    const double px_per_m = PixelsPerMetre(p_camera.z());
    return {center_.x() + px_per_m * p_camera.x(), center_.y() + px_per_m * p_camera.y(), p_camera.z()};
  }
  /// u and v have no meaning where the point is not in front.
  ImagePoint operator()(const Eigen::Vector3d& p_map) const { return FromCamera(ToCamera(p_map)); }

  bool InFront(double depth) const { return !is_perspective_ || depth > kNearestDepth; }
  double PixelsPerMetre(double depth) const { return is_perspective_ ? scale_ / depth : scale_; }

 private:
  Eigen::Matrix3d R_;  // T_camera_map
  Eigen::Vector3d t_;
  Eigen::Vector2d center_;
  double scale_;
  bool is_perspective_;
};

struct PictureSize {
  int width = 1600;   // [px]
  int height = 1200;  // [px]
};

/// Which axis of the map points up in a top view.
enum class Up { kPlusX, kPlusY };

/// Looks straight down (along -z of the map) on `target`, orthographic, `scale` in pixels per metre.
Camera TopView(const PictureSize& size, Up up = Up::kPlusY,
               const Eigen::Vector3d& target_map = Eigen::Vector3d::Zero(), double scale = 50.0);

/// From where an oblique view looks at the target.
struct ObliqueOptions {
  Camera::Projection projection = Camera::Projection::kPerspective;
  double azimuth = -2.0;       // from the target to the eye, from +x towards +y [rad]
  double elevation = 0.6;      // of the eye above the target's horizon, below pi/2 [rad]
  double distance = 20.0;      // from the target to the eye [m]
  double field_of_view = 0.7;  // across the width, perspective only [rad]
  PictureSize size = {};
};

Camera ObliqueView(const Eigen::Vector3d& target_map, const ObliqueOptions& options = {});

/// Perspective camera at `eye` that looks at `target`, with `up` (not along the view) upwards in the
/// picture.
Camera LookAt(const Eigen::Vector3d& eye_map, const Eigen::Vector3d& target_map,
              const Eigen::Vector3d& up_map, double field_of_view, const PictureSize& size);

/// The same view in a picture that is larger by a whole number.
Camera Magnified(Camera camera, int factor);

/// An Error where the camera cannot make a picture: not finite, without pixels, of no scale.
void RequireUsable(const Camera& camera);

}  // namespace ariadne::experiments
