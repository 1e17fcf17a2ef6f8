#include "slam/io/writable.h"

#include <cmath>

#include "slam/base/error.h"
#include "slam/io/point_gatherer.h"

namespace ariadne::slam {

void CheckWritable(const PointCloud& cloud) {
  const auto fits = [&](std::size_t values) { return values == 0 || values == cloud.size(); };
  if (!fits(cloud.reflectance.size()) || !fits(cloud.normals.size())) {
    Fail("cannot write {} points with {} reflectances and {} normals; give one per point or none",
         cloud.size(), cloud.reflectance.size(), cloud.normals.size());
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.positions[i].allFinite()) Fail("cannot write point {}: a coordinate is NaN or infinite", i);
  }
  for (std::size_t i = 0; i < cloud.normals.size(); ++i) {
    if (!UnitNormal(cloud.normals[i])) {
      Fail("cannot write point {}: its normal is zero, NaN or infinite", i);
    }
  }
  for (std::size_t i = 0; i < cloud.reflectance.size(); ++i) {
    if (std::isinf(cloud.reflectance[i])) Fail("cannot write point {}: its reflectance is infinite", i);
  }
}

void CheckWritableWithPoints(const PointCloud& cloud) {
  CheckWritable(cloud);
  if (cloud.empty()) Fail("cannot write a cloud without points in this format; use ply or pcd");
}

void CheckWritable(const Pose3& pose) {
  if (!IsFinite(pose)) Fail("cannot write a pose that is NaN or infinite");
  const double length = pose.rotation.norm();
  if (std::abs(length - 1.0) > 1e-3) {
    Fail("cannot write a pose whose quaternion has length {:.6g}; normalize it", length);
  }
}

std::optional<std::size_t> GridColumns(const PointCloud& cloud) {
  if (!cloud.organized() || cloud.size() % cloud.slice_begin.size() != 0) return std::nullopt;
  const std::size_t columns = cloud.size() / cloud.slice_begin.size();
  for (std::size_t row = 0; row < cloud.slice_begin.size(); ++row) {
    if (cloud.slice_begin[row] != row * columns) return std::nullopt;
  }
  return columns;
}

float FloatCoordinate(double coordinate) {
  const auto rounded = static_cast<float>(coordinate);  // infinite where it does not fit (scalar.h)
  if (!std::isfinite(rounded)) {
    Fail("the coordinate {} m does not fit a float; write the cloud as xyz", coordinate);
  }
  return rounded;
}

}  // namespace ariadne::slam
