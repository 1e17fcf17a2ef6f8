#include "planning/polygon/row_crossings.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace ariadne::planning {
namespace {

constexpr double kSameBeam = 0.002;  // below half of the finest step, 0.25 degrees [rad]

/// A point of a row: rows are planes through the laser's y axis.
struct RowPoint {
  double angle;  // from the right, within the row [rad]
  double range;  // [m]
  Eigen::Vector3d p_map;
};

std::vector<RowPoint> RowOf(const slam::PosedCloud& scan, std::size_t begin, std::size_t end) {
  std::vector<RowPoint> row;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector3d& p = scan.cloud_laser.positions[i];
    const double range = p.norm();
    if (range == 0.0) continue;
    row.push_back({std::acos(std::clamp(-p.y() / range, -1.0, 1.0)), range, scan.T_map_laser * p});
  }
  std::ranges::stable_sort(row, {}, &RowPoint::angle);
  return row;
}

/// Where the line between two points passes the height, if both are outside of the slice.
void AppendCrossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    const slam::HorizontalSliceOptions& slice, std::vector<Eigen::Vector2d>& crossings) {
  const double below = slice.height - slice.half_thickness;
  const double above = slice.height + slice.half_thickness;
  if (std::min(a.z(), b.z()) >= below || std::max(a.z(), b.z()) <= above) return;
  const double share = (slice.height - a.z()) / (b.z() - a.z());
  crossings.emplace_back((a + share * (b - a)).head<2>());
}

}  // namespace

std::vector<Eigen::Vector2d> RowCrossings(const slam::PosedCloud& scan,
                                          const slam::HorizontalSliceOptions& slice, double max_jump) {
  slam::RequireFinite(scan);
  const std::vector<std::size_t>& begins = scan.cloud_laser.slice_begin;
  std::vector<Eigen::Vector2d> crossings;
  std::vector<RowPoint> previous;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : scan.cloud_laser.size();
    std::vector<RowPoint> row = RowOf(scan, begins[k], end);
    auto below = previous.begin();
    for (const RowPoint& point : row) {
      while (below != previous.end() && below->angle < point.angle - kSameBeam) ++below;
      if (below == previous.end()) break;
      const bool same = below->angle <= point.angle + kSameBeam;
      if (!same || std::abs(below->range - point.range) > max_jump) continue;
      AppendCrossing(below->p_map, point.p_map, slice, crossings);
    }
    previous = std::move(row);
  }
  return crossings;
}

}  // namespace ariadne::planning
