#include "planning/view/edge_set.h"

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne::planning {
namespace {

constexpr double kFarthest = 1e8;  // products of two coordinates stay exact enough to order hits [m]

bool IsPlace(const Eigen::Vector2d& p) { return p.cwiseAbs().maxCoeff() <= kFarthest && p.allFinite(); }

void AppendEdges(const slam::Ring& ring, bool seen, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({ring[i], ring[(i + 1) % ring.size()], seen});
  }
}

}  // namespace

std::vector<Edge> EdgesOf(const slam::Polygon2& polygon, bool seen) {
  std::vector<Edge> edges;
  AppendEdges(polygon.outer, seen, edges);
  for (const slam::Ring& hole : polygon.holes) AppendEdges(hole, seen, edges);
  return edges;
}

double Distance(const Edge& edge, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d along = edge.to - edge.from;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p_map - edge.from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p_map - edge.from - share * along).norm();
}

void RequirePlaces(std::span<const Edge> edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [from, to, seen] = edges[i];
    if (IsPlace(from) && IsPlace(to)) continue;
    Fail("edge {} from ({}, {}) to ({}, {}) has an end that is no place", i, from.x(), from.y(), to.x(),
         to.y());
  }
}

void RequirePlaces(std::span<const Eigen::Vector2d> places, const char* what) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!IsPlace(places[i])) Fail("{} {} at ({}, {}) is no place", what, i, places[i].x(), places[i].y());
  }
}

}  // namespace ariadne::planning
