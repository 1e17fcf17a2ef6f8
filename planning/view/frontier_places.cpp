#include "planning/view/frontier_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::planning {
namespace {

constexpr double kSpacing = 1.0;                                          // along an edge [m]
constexpr std::array kBefore{0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};   // beyond the radius [m]
constexpr std::array kAside{0.4, -0.4, 0.8, -0.8, 1.1, -1.1, 1.4, -1.4};  // from straight before [rad]

using Vectors = std::vector<Eigen::Vector2d>;

/// The nearest free place before a place on an edge, in a direction.
void AppendBefore(const Eigen::Vector2d& p_map, const Eigen::Vector2d& direction, const FreeSpace& free,
                  double radius, Vectors& places) {
  for (const double before : kBefore) {
    const Eigen::Vector2d place = p_map + (radius + before) * direction;
    if (!free.IsFree(place, radius)) continue;
    places.push_back(place);
    return;
  }
}

}  // namespace

std::vector<Eigen::Vector2d> FrontierPlaces(std::span<const Edge> edges, const FreeSpace& free,
                                            double radius, FrontierSide side) {
  std::vector<const Edge*> unseen;
  for (const Edge& edge : edges) {
    if (!edge.seen && edge.from != edge.to) unseen.push_back(&edge);
  }
  std::ranges::stable_sort(unseen, [](const Edge* a, const Edge* b) {
    return (a->to - a->from).squaredNorm() > (b->to - b->from).squaredNorm();
  });
  std::vector<Eigen::Vector2d> places;
  for (const Edge* edge : unseen) {
    const Eigen::Vector2d along = edge->to - edge->from;
    const Eigen::Vector2d inwards = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const int parts = std::max(1, static_cast<int>(std::lround(along.norm() / kSpacing)));
    for (int k = 0; k < parts; ++k) {
      const Eigen::Vector2d p = edge->from + (k + 0.5) / parts * along;
      if (side == FrontierSide::kBefore) AppendBefore(p, inwards, free, radius, places);
      if (side == FrontierSide::kBefore) continue;
      for (const double turn : kAside)
        AppendBefore(p, Eigen::Rotation2Dd(turn) * inwards, free, radius, places);
    }
  }
  return places;
}

}  // namespace ariadne::planning
