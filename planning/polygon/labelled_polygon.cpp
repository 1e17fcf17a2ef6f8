#include "planning/polygon/labelled_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/base/error.h"

namespace ariadne::planning {
namespace {

constexpr double kFarthest = 1e5;   // what the docstring promises [m]
constexpr double kTouching = 1e-3;  // unions round to 0.1 mm, and thin wedges cross by some of that [m]

struct PlainEdge {
  Eigen::Vector2d from, to;

  double Left() const { return std::min(from.x(), to.x()); }
  double Right() const { return std::max(from.x(), to.x()); }
};

slam::Ring CornersOf(const LabelledRing& ring) {
  slam::Ring corners;
  corners.reserve(ring.size());
  for (const LabelledCorner& corner : ring) corners.push_back(corner.p_map);
  return corners;
}

double LengthOf(const LabelledRing& ring, bool seen) {
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].seen == seen) length += (ring[(i + 1) % ring.size()].p_map - ring[i].p_map).norm();
  }
  return length;
}

double LengthOf(const LabelledPolygon& polygon, bool seen) {
  double length = LengthOf(polygon.outer, seen);
  for (const LabelledRing& hole : polygon.holes) length += LengthOf(hole, seen);
  return length;
}

bool ApartInY(const PlainEdge& a, const PlainEdge& b) {
  return std::max(a.from.y(), a.to.y()) < std::min(b.from.y(), b.to.y()) ||
         std::max(b.from.y(), b.to.y()) < std::min(a.from.y(), a.to.y());
}

/// Whether the ends of `edge` are on different sides of the line through `line`.
bool LiesAcross(const PlainEdge& edge, const PlainEdge& line) {
  const Eigen::Vector2d along = line.to - line.from;
  const double length = along.norm();
  if (length == 0.0) return false;
  const auto side = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d d = p - line.from;
    return (along.x() * d.y() - along.y() * d.x()) / length;
  };
  const double from = side(edge.from);
  const double to = side(edge.to);
  return (from > kTouching && to < -kTouching) || (from < -kTouching && to > kTouching);
}

void AppendEdges(const LabelledRing& ring, std::vector<PlainEdge>& edges) {
  if (ring.size() < 3) Fail("a ring of a polygon has {} corners; it needs three", ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& p = ring[i].p_map;
    if (!(p.cwiseAbs().maxCoeff() < kFarthest) || !p.allFinite()) {
      Fail("a polygon has the corner ({}, {}), which is no place within {} m", p.x(), p.y(), kFarthest);
    }
    edges.push_back({p, ring[(i + 1) % ring.size()].p_map});
  }
}

}  // namespace

slam::Polygon2 ToPolygon2(const LabelledPolygon& polygon) {
  slam::Polygon2 plain{CornersOf(polygon.outer), {}};
  for (const LabelledRing& hole : polygon.holes) plain.holes.push_back(CornersOf(hole));
  return plain;
}

double SeenLength(const LabelledPolygon& polygon) { return LengthOf(polygon, true); }

double UnseenLength(const LabelledPolygon& polygon) { return LengthOf(polygon, false); }

LabelledPolygon UnseenDisc(const Eigen::Vector2d& center_map, double radius, int corners) {
  LabelledPolygon disc;
  for (int i = 0; i < corners && radius > 0.0; ++i) {
    const double bearing = 2.0 * std::numbers::pi * i / corners;
    disc.outer.push_back(
        {center_map + radius * Eigen::Vector2d(std::cos(bearing), std::sin(bearing)), false});
  }
  return disc;
}

bool Contains(const LabelledPolygon& polygon, const Eigen::Vector2d& p_map) {
  return slam::Contains(ToPolygon2(polygon), p_map);
}

void RequireSimple(const LabelledPolygon& polygon) {
  if (polygon.empty()) {
    if (!polygon.holes.empty()) Fail("a polygon has holes but no outer ring");
    return;
  }
  std::vector<PlainEdge> edges;
  AppendEdges(polygon.outer, edges);
  for (const LabelledRing& hole : polygon.holes) AppendEdges(hole, edges);
  std::ranges::stable_sort(edges, {}, &PlainEdge::Left);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].Left() <= edges[i].Right(); ++j) {
      if (ApartInY(edges[i], edges[j]) || !LiesAcross(edges[i], edges[j]) ||
          !LiesAcross(edges[j], edges[i]))
        continue;
      Fail("edges of a polygon cross, those from ({}, {}) and from ({}, {})", edges[i].from.x(),
           edges[i].from.y(), edges[j].from.x(), edges[j].from.y());
    }
  }
}

}  // namespace ariadne::planning
