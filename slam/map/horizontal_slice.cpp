#include "slam/map/horizontal_slice.h"

#include <cmath>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

/// A pose as seen from above: its place, and where its x axis points.
Pose2 SeenFromAbove(const Pose3& T_map_laser) {
  const Eigen::Vector3d ahead = T_map_laser.rotation * Eigen::Vector3d::UnitX();
  return {std::atan2(ahead.y(), ahead.x()), T_map_laser.translation.head<2>()};
}

}  // namespace

void RequireFinite(const PosedCloud& scan) {
  if (!IsFinite(scan.T_map_laser)) Fail("the pose of scan '{}' is NaN or infinite", scan.name);
  if (const auto point = FirstNonFinite(scan.cloud_laser)) {
    Fail("point {} of scan '{}' has a coordinate that is NaN or infinite; leave it out", *point, scan.name);
  }
}

HorizontalSlice SliceAt(const PosedCloud& scan, const HorizontalSliceOptions& options) {
  CheckOptions(options, "slice.");
  RequireFinite(scan);
  HorizontalSlice slice{scan.name, SeenFromAbove(scan.T_map_laser), {}};
  for (const Eigen::Vector3d& p_laser : scan.cloud_laser.positions) {
    const Eigen::Vector3d p_map = scan.T_map_laser * p_laser;
    if (std::abs(p_map.z() - options.height) > options.half_thickness) continue;
    slice.points_map.emplace_back(p_map.head<2>());
  }
  return slice;
}

std::vector<HorizontalSlice> SlicesAt(std::span<const PosedCloud> scans,
                                      const HorizontalSliceOptions& options) {
  std::vector<HorizontalSlice> slices;
  slices.reserve(scans.size());
  for (const PosedCloud& scan : scans) slices.push_back(SliceAt(scan, options));
  return slices;
}

}  // namespace ariadne::slam
