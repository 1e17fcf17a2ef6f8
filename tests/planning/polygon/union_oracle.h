#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "planning/polygon/labelled_polygon.h"

/// An oracle for labelled unions that shares nothing with them: each edge is cut at all others, and a piece
/// is boundary where some polygon winds round the places on its left and none round those on its right.
namespace ariadne::planning::oracle {

/// Corners are whole numbers of 0.1 mm, as in the union, so that it is exact which edges are parallel, lie
/// on each other or touch. Places within an edge have 64 bits, 1e-15 of its length.
constexpr double kUnitsPerMeter = 1e4;
using Real = long double;

struct Place {
  std::int64_t x = 0, y = 0;
  bool operator==(const Place&) const = default;
};

struct GridEdge {
  Place a, b;
  std::size_t polygon = 0;
  bool seen = false;
};

/// A piece of a boundary in metres, with the area on its left.
struct Piece {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  bool seen = false;

  double Length() const { return (to - from).norm(); }
};

inline std::int64_t Cross(const Place& o, const Place& a, const Place& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

inline Place OnGrid(const Eigen::Vector2d& p) {
  return {std::llround(p.x() * kUnitsPerMeter), std::llround(p.y() * kUnitsPerMeter)};
}

inline void AppendRing(const LabelledRing& ring, std::size_t polygon, std::vector<GridEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridEdge edge{OnGrid(ring[i].p_map), OnGrid(ring[(i + 1) % ring.size()].p_map), polygon,
                        ring[i].seen};
    if (!(edge.a == edge.b)) edges.push_back(edge);
  }
}

/// Outer rings must run counterclockwise, holes clockwise.
inline std::vector<GridEdge> EdgesOf(std::span<const LabelledPolygon> polygons) {
  std::vector<GridEdge> edges;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    AppendRing(polygons[i].outer, i, edges);
    for (const LabelledRing& hole : polygons[i].holes) AppendRing(hole, i, edges);
  }
  return edges;
}

/// One edge as the x axis: what the others are beside it.
class EdgeFrame {
 public:
  explicit EdgeFrame(const GridEdge& edge)
      : edge_(edge), dx_(edge.b.x - edge.a.x), dy_(edge.b.y - edge.a.y), square_(dx_ * dx_ + dy_ * dy_) {}

  std::int64_t Side(const Place& p) const { return Cross(edge_.a, edge_.b, p); }  // positive: left
  std::int64_t Along(const Place& p) const { return (p.x - edge_.a.x) * dx_ + (p.y - edge_.a.y) * dy_; }
  Real Share(const Place& p) const { return static_cast<Real>(Along(p)) / square_; }
  bool OnLine(const GridEdge& other) const { return Side(other.a) == 0 && Side(other.b) == 0; }
  Eigen::Vector2d At(Real share) const {
    return {static_cast<double>((edge_.a.x + share * dx_) / kUnitsPerMeter),
            static_cast<double>((edge_.a.y + share * dy_) / kUnitsPerMeter)};
  }
  Real Units(Real share) const { return share * std::sqrt(static_cast<Real>(square_)); }

  /// Where along the edge others touch or cross it, ascending, its own ends included.
  std::vector<Real> Cuts(std::span<const GridEdge> others) const {
    std::vector<Real> cuts{0.0L, 1.0L};
    for (const GridEdge& other : others) {
      const std::int64_t a = Side(other.a), b = Side(other.b);
      if ((a > 0 && b > 0) || (a < 0 && b < 0)) continue;
      if (a == 0) cuts.push_back(Share(other.a));
      if (b == 0) cuts.push_back(Share(other.b));
      if (a == 0 || b == 0) continue;
      const Real share = static_cast<Real>(a) / (static_cast<Real>(a) - static_cast<Real>(b));
      cuts.push_back(Share(other.a) + share * (Share(other.b) - Share(other.a)));
    }
    std::erase_if(cuts, [](Real cut) { return cut < 0.0L || cut > 1.0L; });
    std::ranges::sort(cuts);
    return cuts;
  }

 private:
  GridEdge edge_;
  std::int64_t dx_, dy_, square_;
};

struct Sides {
  bool left = false, right = false;  // covered
};

/// What lies immediately beside a place on an edge: for each polygon, which of its edges two rays at right
/// angles to the edge cross, one to either side. Edges on the same line lie behind where the rays begin.
inline Sides CoveredSides(const EdgeFrame& frame, Real share, std::span<const GridEdge> edges) {
  Sides sides;
  int left = 0, right = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const GridEdge& edge = edges[i];
    const Real a = frame.Share(edge.a) - share, b = frame.Share(edge.b) - share;
    if ((a < 0.0L) != (b < 0.0L) && !frame.OnLine(edge)) {
      const Real side_a = frame.Side(edge.a), side_b = frame.Side(edge.b);
      const int forward = a < b ? 1 : -1;
      (side_a + a / (a - b) * (side_b - side_a) > 0.0L ? left : right) += forward;
    }
    if (i + 1 < edges.size() && edges[i + 1].polygon == edge.polygon) continue;
    sides.left = sides.left || left != 0;
    sides.right = sides.right || right != 0;
    left = right = 0;
  }
  return sides;
}

/// The boundary of the union; where edges lie on each other, once, and seen if one of them is.
inline std::vector<Piece> Boundary(std::span<const LabelledPolygon> polygons) {
  const std::vector<GridEdge> edges = EdgesOf(polygons);
  std::vector<Piece> boundary;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgeFrame frame(edges[i]);
    const std::vector<Real> cuts = frame.Cuts(edges);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Real middle = 0.5L * (cuts[k] + cuts[k + 1]);
      if (frame.Units(cuts[k + 1] - cuts[k]) < 1e-6L) continue;
      const Sides sides = CoveredSides(frame, middle, edges);
      if (!sides.left || sides.right) continue;
      bool seen = false, first = true;
      for (std::size_t j = 0; j < edges.size(); ++j) {
        if (!frame.OnLine(edges[j])) continue;
        if (!(frame.Share(edges[j].a) < middle && frame.Share(edges[j].b) > middle)) continue;
        seen = seen || edges[j].seen;
        first = first && j >= i;
      }
      if (first) boundary.push_back({frame.At(cuts[k]), frame.At(cuts[k + 1]), seen});
    }
  }
  return boundary;
}

}  // namespace ariadne::planning::oracle
