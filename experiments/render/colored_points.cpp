#include "experiments/render/colored_points.h"

#include <utility>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// Calls visit(scan, index, p_map) for each point whose height in the map lies in the band.
template <typename Visit>
void ForEachPoint(const std::vector<slam::PosedCloud>& scans, const HeightBand& heights,
                  const Visit& visit) {
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    const Eigen::Matrix3d R = scans[scan].T_map_laser.RotationMatrix();
    const std::vector<Eigen::Vector3d>& positions_laser = scans[scan].cloud_laser.positions;
    for (std::size_t i = 0; i < positions_laser.size(); ++i) {
      const Eigen::Vector3d p_map = R * positions_laser[i] + scans[scan].T_map_laser.translation;
      if (!heights.Excludes(p_map)) visit(scan, i, p_map);
    }
  }
}

std::vector<double> HeightsOf(const std::vector<Eigen::Vector3d>& positions_map) {
  std::vector<double> heights;
  heights.reserve(positions_map.size());
  for (const Eigen::Vector3d& p : positions_map) heights.push_back(p.z());
  return heights;
}

}  // namespace

std::vector<Eigen::Vector3d> PositionsInMap(const std::vector<slam::PosedCloud>& scans,
                                            const HeightBand& heights) {
  std::vector<Eigen::Vector3d> positions_map;
  ForEachPoint(scans, heights, [&](std::size_t, std::size_t, const Eigen::Vector3d& p_map) {
    positions_map.push_back(p_map);
  });
  return positions_map;
}

ColoredPoints ColoredByScan(const std::vector<slam::PosedCloud>& scans, const HeightBand& heights) {
  ColoredPoints points;
  ForEachPoint(scans, heights, [&](std::size_t scan, std::size_t, const Eigen::Vector3d& p_map) {
    points.positions_map.push_back(p_map);
    points.colors.push_back(CategoricalColor(scan));
  });
  return points;
}

ColoredPoints ColoredByValue(std::vector<Eigen::Vector3d> positions_map, const std::vector<double>& values,
                             ColorMap map, const ValueRange& range) {
  if (values.size() != positions_map.size()) {
    Fail("{} points cannot be coloured by {} values", positions_map.size(), values.size());
  }
  ColoredPoints points{std::move(positions_map), {}};
  points.colors.reserve(values.size());
  for (const double value : values) points.colors.push_back(ColorAt(map, range.Share(value)));
  return points;
}

ValueRange HeightRange(const std::vector<Eigen::Vector3d>& positions_map, double outlier_share) {
  return RobustRange(HeightsOf(positions_map), outlier_share);
}

ColoredPoints ColoredByHeight(std::vector<Eigen::Vector3d> positions_map, const ValueRange& range,
                              ColorMap map) {
  const std::vector<double> heights = HeightsOf(positions_map);
  return ColoredByValue(std::move(positions_map), heights, map, range);
}

ColoredPoints ColoredByReflectance(const std::vector<slam::PosedCloud>& scans, const HeightBand& heights,
                                   ColorMap map) {
  for (const slam::PosedCloud& scan : scans) {
    if (scan.cloud_laser.reflectance.size() != scan.cloud_laser.size()) {
      Fail("{}: the scan has no reflectance by which it could be coloured", scan.name);
    }
  }
  std::vector<Eigen::Vector3d> positions_map;
  std::vector<double> values;
  ForEachPoint(scans, heights, [&](std::size_t scan, std::size_t i, const Eigen::Vector3d& p_map) {
    positions_map.push_back(p_map);
    values.push_back(scans[scan].cloud_laser.reflectance[i]);
  });
  return ColoredByValue(std::move(positions_map), values, map, RobustRange(values));
}

ColoredPoints Lightened(ColoredPoints points, double share) {
  for (Rgb& color : points.colors) color = Mix(color, kWhite, share);
  return points;
}

void RequireDrawable(const ColoredPoints& points) {
  if (points.colors.size() != points.positions_map.size()) {
    Fail("{} points with {} colours cannot be drawn", points.positions_map.size(), points.colors.size());
  }
  for (std::size_t i = 0; i < points.positions_map.size(); ++i) {
    if (points.positions_map[i].allFinite()) continue;
    Fail("point {} of {} to be drawn is not finite", i, points.positions_map.size());
  }
}

}  // namespace ariadne::experiments
