#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "experiments/render/color_map.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

/// What a view shows: points of the map, each with its colour.
struct ColoredPoints {
  std::vector<Eigen::Vector3d> positions_map;  // [m]
  std::vector<Rgb> colors;                     // one per point
};

/// The points between two heights of the map; without the ceiling one can look into rooms. [m]
struct HeightBand {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  /// False for NaN, so that a point that is not finite is not lost here but refused by the view.
  bool Excludes(const Eigen::Vector3d& p_map) const { return p_map.z() < min || p_map.z() > max; }
};

/// The points of all scans in a band of heights, scan after scan.
std::vector<Eigen::Vector3d> PositionsInMap(const std::vector<slam::PosedCloud>& scans,
                                            const HeightBand& heights = {});

/// Each scan in its own categorical colour.
ColoredPoints ColoredByScan(const std::vector<slam::PosedCloud>& scans, const HeightBand& heights = {});

/// Colours for one value per point: reflectance, error, time.
ColoredPoints ColoredByValue(std::vector<Eigen::Vector3d> positions_map, const std::vector<double>& values,
                             ColorMap map, const ValueRange& range);

/// From floor to ceiling: the range of z without outliers. [m]
ValueRange HeightRange(const std::vector<Eigen::Vector3d>& positions_map, double outlier_share = 0.01);

ColoredPoints ColoredByHeight(std::vector<Eigen::Vector3d> positions_map, const ValueRange& range,
                              ColorMap map = ColorMap::kShore);

/// Grey values from the reflectance, which every scan must have; without outliers.
ColoredPoints ColoredByReflectance(const std::vector<slam::PosedCloud>& scans,
                                   const HeightBand& heights = {}, ColorMap map = ColorMap::kGray);

/// The colours mixed with a share of white: for shaded views, where saturated colours look heavy.
ColoredPoints Lightened(ColoredPoints points, double share = 0.2);

/// An Error where a point is not finite or the number of colours is not that of the points.
void RequireDrawable(const ColoredPoints& points);

}  // namespace ariadne::experiments
