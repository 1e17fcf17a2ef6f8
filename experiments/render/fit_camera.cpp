#include "experiments/render/fit_camera.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/percentile.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kMaxSamples = 100'000;  // of the points, evenly taken: enough for a percentile
constexpr double kSmallestExtent = 0.1;       // that a picture shows, for a single point [m]
constexpr int kTallest = 2;                   // height of a picture as a multiple of its width

std::vector<Eigen::Vector3d> SampledInCamera(const Camera& camera,
                                             const std::vector<Eigen::Vector3d>& positions_map) {
  const Projector project(camera);
  const std::size_t stride = positions_map.size() / kMaxSamples + 1;
  std::vector<Eigen::Vector3d> sampled;
  for (std::size_t i = 0; i < positions_map.size(); i += stride) {
    sampled.push_back(project.ToCamera(positions_map[i]));
    if (!sampled.back().allFinite()) Fail("point {} to which a camera is fitted is not finite", i);
  }
  return sampled;
}

/// From the lowest to the highest of some values, without outliers.
struct Reach {
  double low = 0.0;
  double high = 0.0;
};

/// How far the points reach in the camera's frame along x or y, as seen under the slope of the picture's
/// sides: the side x = slope * z + c through the outermost point has c = `high`; that of the other side,
/// x = -slope * z + c, has c = `low`. Slope 0 is the orthographic camera. [m]
Reach ReachAlong(int axis, double slope, const std::vector<Eigen::Vector3d>& points_camera,
                 double outlier_share) {
  std::vector<double> low, high;
  low.reserve(points_camera.size());
  high.reserve(points_camera.size());
  for (const Eigen::Vector3d& p : points_camera) {
    low.push_back(p[axis] + slope * p.z());
    high.push_back(p[axis] - slope * p.z());
  }
  Reach reach{Percentile(std::move(low), outlier_share), Percentile(std::move(high), 1.0 - outlier_share)};
  if (slope == 0.0 && reach.high - reach.low < kSmallestExtent) {
    reach.low -= 0.5 * kSmallestExtent;
    reach.high += 0.5 * kSmallestExtent;
  }
  return reach;
}

double Middle(const Reach& reach) { return 0.5 * (reach.low + reach.high); }

/// Moves the eye by a vector in its own frame.
void MoveEye(Camera& camera, const Eigen::Vector3d& step_camera) {
  camera.T_camera_map.translation -= step_camera;
}

/// Half the width and height that the content may fill. [px]
Eigen::Vector2d HalfRoom(const Camera& camera, int margin) {
  Eigen::Vector2d room(0.5 * camera.width - margin, 0.5 * camera.height - margin);
  if (room.minCoeff() < 1.0) {
    Fail("a picture of {} x {} pixels has no room within margins of {}", camera.width, camera.height,
         margin);
  }
  return room;
}

void FitOrthographic(Camera& camera, const std::vector<Eigen::Vector3d>& points_camera,
                     const FitOptions& options) {
  const Eigen::Vector2d room = HalfRoom(camera, options.margin);
  const Reach x = ReachAlong(0, 0.0, points_camera, options.outlier_share);
  const Reach y = ReachAlong(1, 0.0, points_camera, options.outlier_share);
  const double scale_x = 2.0 * room.x() / (x.high - x.low);
  const double scale_y = 2.0 * room.y() / (y.high - y.low);
  camera.scale = options.adjust_height ? scale_x : std::min(scale_x, scale_y);
  MoveEye(camera, {Middle(x), Middle(y), 0.0});
}

/// The sides of the picture are planes through the eye (ex, ey, ez): high = ex - slope * ez and
/// low = ex + slope * ez put the outermost points on them.
void FitPerspective(Camera& camera, const std::vector<Eigen::Vector3d>& points_camera,
                    const FitOptions& options) {
  const Eigen::Vector2d slope = HalfRoom(camera, options.margin) / camera.scale;
  const Reach x = ReachAlong(0, slope.x(), points_camera, options.outlier_share);
  const Reach y = ReachAlong(1, slope.y(), points_camera, options.outlier_share);
  const double back_x = 0.5 * (x.high - x.low) / slope.x();
  const double back_y = 0.5 * (y.high - y.low) / slope.y();
  double back = options.adjust_height ? back_x : std::max(back_x, back_y);
  const double nearest = ReachAlong(2, 0.0, points_camera, options.outlier_share).low;
  back = std::max(back, 0.5 * kSmallestExtent / slope.x() - nearest);  // keeps away from a single point
  MoveEye(camera, {Middle(x), Middle(y), -back});
}

/// The rows that the points take. [px]
Reach RowsOf(const Camera& camera, const std::vector<Eigen::Vector3d>& positions_map,
             double outlier_share) {
  const Projector project(camera);
  std::vector<double> rows;
  for (const Eigen::Vector3d& p_camera : SampledInCamera(camera, positions_map)) {
    if (project.InFront(p_camera.z())) rows.push_back(project.FromCamera(p_camera).v);
  }
  return {Percentile(rows, outlier_share), Percentile(rows, 1.0 - outlier_share)};
}

Camera FittedInside(const Camera& camera, const std::vector<Eigen::Vector3d>& positions_map,
                    const FitOptions& options) {
  Camera fitted = camera;
  fitted.center = {0.5 * camera.width, 0.5 * camera.height};
  const std::vector<Eigen::Vector3d> points_camera = SampledInCamera(fitted, positions_map);
  if (camera.projection == Camera::Projection::kOrthographic) {
    FitOrthographic(fitted, points_camera, options);
  } else {
    FitPerspective(fitted, points_camera, options);
  }
  return fitted;
}

}  // namespace

Camera Fitted(const Camera& camera, const std::vector<Eigen::Vector3d>& positions_map,
              const FitOptions& options) {
  CheckOptions(options, "fit of a camera: ");
  if (positions_map.empty()) return camera;
  Camera fitted = FittedInside(camera, positions_map, options);
  if (!options.adjust_height) return fitted;

  const Reach rows = RowsOf(fitted, positions_map, options.outlier_share);
  const double height = std::ceil(rows.high - rows.low) + 2.0 * options.margin;
  if (height > kTallest * camera.width) {  // full width would make a picture that fits on no page
    fitted.height = kTallest * camera.width;
    return FittedInside(fitted, positions_map, {options.outlier_share, options.margin, false});
  }
  fitted.height = static_cast<int>(height);
  fitted.center.y() += 0.5 * fitted.height - Middle(rows);
  return fitted;
}

}  // namespace ariadne::experiments
