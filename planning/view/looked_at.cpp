#include "planning/view/looked_at.h"

#include <algorithm>
#include <cmath>

namespace ariadne::planning {
namespace {

constexpr double kSteeper = 2.0;

double SineBetween(const Edge& edge, const Eigen::Vector2d& ray) {
  const Eigen::Vector2d along = (edge.to - edge.from).normalized();
  return std::abs(along.x() * ray.y() - along.y() * ray.x());
}

}  // namespace

LookedAt::LookedAt(std::span<const Edge> edges, std::span<const slam::Pose2> T_map_scans,
                   const RayGainOptions& options, double piece_length)
    : edges_(edges), piece_length_(piece_length) {
  for (const slam::Pose2& T_map_scan : T_map_scans) {
    const RayGain rays(edges, T_map_scan.angle, options);
    const std::vector<RayHit> hits = rays.Cast(T_map_scan.translation);
    for (const std::size_t i : rays.RaysAbout(T_map_scan.angle)) {
      if (!rays.IsUnseen(hits[i])) continue;
      const Eigen::Vector2d p_map = T_map_scan.translation + hits[i].distance * rays.Direction(i);
      const double sine = SineBetween(edges[hits[i].edge], rays.Direction(i));
      looks_[PieceOf(hits[i].edge, p_map)].push_back({hits[i].distance, sine});
    }
  }
}

LookedAt::Piece LookedAt::PieceOf(std::size_t edge, const Eigen::Vector2d& p_map) const {
  return {edge, std::lround((p_map - edges_[edge].from).norm() / piece_length_)};
}

bool LookedAt::IsWorth(const Eigen::Vector2d& p_map, const Eigen::Vector2d& direction, const RayHit& hit,
                       double share) const {
  const auto found = looks_.find(PieceOf(hit.edge, p_map));
  if (found == looks_.end()) return true;
  const double sine = SineBetween(edges_[hit.edge], direction);
  return std::ranges::none_of(found->second, [&](const Look& look) {
    return hit.distance >= share * look.distance && sine <= kSteeper * look.sine;
  });
}

}  // namespace ariadne::planning
