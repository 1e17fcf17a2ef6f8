#include "experiments/report/map_cameras.h"

#include "experiments/render/fit_camera.h"

namespace ariadne::experiments {
namespace {

using Scans = std::vector<slam::PosedCloud>;

constexpr double kAzimuth = -2.0;  // from where oblique views look [rad]
constexpr double kElevation = 0.75;

}  // namespace

HeightBand WithoutCeiling(const Scans& scans) {
  const ValueRange heights = HeightRange(PositionsInMap(scans));
  return {.max = heights.low + 0.85 * (heights.high - heights.low)};
}

Camera TopCamera(const Scans& frame) {
  return Fitted(TopView({1600, 1200}), PositionsInMap(frame),
                {.outlier_share = 0.002, .adjust_height = true});
}

Camera ObliqueCamera(const Scans& frame, int width) {
  const ObliqueOptions view{.azimuth = kAzimuth, .elevation = kElevation, .size = {width, width * 3 / 4}};
  return Fitted(ObliqueView(Eigen::Vector3d::Zero(), view), PositionsInMap(frame, WithoutCeiling(frame)),
                {.adjust_height = true});
}

}  // namespace ariadne::experiments
