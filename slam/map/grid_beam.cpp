#include "slam/map/grid_beam.h"

#include <algorithm>

namespace ariadne::slam {

std::optional<GridBeam> ClipBeam(const Eigen::Vector3d& viewpoint_map, const Eigen::Vector3d& p_map,
                                 const HeightBand& band, double max_range) {
  const Eigen::Vector3d way = p_map - viewpoint_map;
  double first = 0.0, last = 1.0;  // shares of the way
  if (max_range > 0.0) last = std::min(last, max_range / way.norm());
  if (way.z() != 0.0) {
    const double at_low = (band.low - viewpoint_map.z()) / way.z();
    const double at_high = (band.high - viewpoint_map.z()) / way.z();
    first = std::max(first, std::min(at_low, at_high));
    last = std::min(last, std::max(at_low, at_high));
  } else if (viewpoint_map.z() < band.low || viewpoint_map.z() > band.high) {
    return std::nullopt;
  }
  if (!(first <= last)) return std::nullopt;
  const bool hits = last == 1.0;
  const auto at = [&](double share) -> Eigen::Vector3d { return viewpoint_map + share * way; };
  return GridBeam{at(first), hits ? p_map : at(last), hits};
}

}  // namespace ariadne::slam
