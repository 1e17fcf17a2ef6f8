#include "planning/polygon/boundary_labels.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ariadne::planning {
namespace {

constexpr double kSameLine = 1e-8;  // what the docstring promises [m]
constexpr double kAnyAngle = 0.8;   // within the rounding, an edge lies along a boundary up to here [rad]

/// An edge beside another, in the frame of that: x along it, y to its left.
struct Beside {
  Stretch stretch;
  double at_zero = 0.0;  // its offset y at x = 0, on its line [m]
  double slope = 0.0;
  bool seen = false;

  double Offset(double x) const { return at_zero + slope * x; }
};

/// Where the edge from p along the unit vector runs beside another, up to `distance` from it.
std::optional<Beside> RunBeside(const Eigen::Vector2d& p, const Eigen::Vector2d& along, double length,
                                const DirectedEdge& edge, double distance, double max_slope) {
  const Eigen::Vector2d q = p + length * along;
  if (std::max(edge.from.x(), edge.to.x()) + distance < std::min(p.x(), q.x()) ||
      std::min(edge.from.x(), edge.to.x()) - distance > std::max(p.x(), q.x())) {
    return {};  // most edges
  }
  const double begin = along.dot(edge.from - p);
  const double end = along.dot(edge.to - p);
  if (begin >= end || begin >= length || end <= 0.0) return {};
  const Eigen::Vector2d across(-along.y(), along.x());
  const double from = across.dot(edge.from - p);
  const double to = across.dot(edge.to - p);
  if (std::min(from, to) > distance || std::max(from, to) < -distance) return {};
  const double slope = (to - from) / (end - begin);
  if (std::abs(slope) > max_slope) return {};
  Beside beside{{std::max(begin, 0.0), std::min(end, length)}, from - slope * begin, slope, edge.seen};
  if (std::abs(to - from) > 1e-12) {
    const double center = begin - from / slope;  // where the two lines meet
    beside.stretch.begin = std::max(beside.stretch.begin, center - distance / std::abs(slope));
    beside.stretch.end = std::min(beside.stretch.end, center + distance / std::abs(slope));
  }
  if (beside.stretch.begin >= beside.stretch.end) return {};
  return beside;
}

/// Where it may change which edge is the outermost: where one begins or ends, or two cross.
std::vector<double> Changes(const std::vector<Beside>& edges) {
  std::vector<double> changes;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    changes.push_back(edges[i].stretch.begin);
    changes.push_back(edges[i].stretch.end);
    for (std::size_t j = 0; j < i; ++j) {
      const double turning = edges[i].slope - edges[j].slope;
      if (std::abs(turning) < 1e-12) continue;
      changes.push_back((edges[j].at_zero - edges[i].at_zero) / turning);
    }
  }
  std::ranges::sort(changes);
  return changes;
}

/// The label of the edge farthest to the right, where the area ends. No edge there: unseen.
bool OutermostSeen(const std::vector<Beside>& edges, double x) {
  std::optional<double> outermost;
  bool seen = false;
  for (const Beside& edge : edges) {
    if (x < edge.stretch.begin || x > edge.stretch.end) continue;
    const double offset = edge.Offset(x);
    if (!outermost || offset < *outermost - kSameLine) {
      outermost = offset;
      seen = edge.seen;
    } else if (offset <= *outermost + kSameLine) {
      outermost = std::min(*outermost, offset);
      seen = seen || edge.seen;
    }
  }
  return seen;
}

void AppendDirected(const LabelledRing& ring, bool is_hole, std::vector<DirectedEdge>& edges) {
  const bool clockwise = slam::SignedArea(ToPolygon2({ring, {}}).outer) < 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& from = ring[i].p_map;
    const Eigen::Vector2d& to = ring[(i + 1) % ring.size()].p_map;
    if (from == to) continue;
    edges.push_back(clockwise == is_hole ? DirectedEdge{from, to, ring[i].seen}
                                         : DirectedEdge{to, from, ring[i].seen});
  }
}

}  // namespace

std::vector<DirectedEdge> DirectedEdges(std::span<const LabelledPolygon> polygons) {
  std::vector<DirectedEdge> edges;
  for (const LabelledPolygon& polygon : polygons) {
    AppendDirected(polygon.outer, false, edges);
    for (const LabelledRing& hole : polygon.holes) AppendDirected(hole, true, edges);
  }
  return edges;
}

std::vector<Stretch> SeenStretches(const Eigen::Vector2d& p, const Eigen::Vector2d& along, double length,
                                   std::span<const DirectedEdge> edges) {
  std::vector<Beside> beside;
  for (const DirectedEdge& edge : edges) {
    if (const auto one = RunBeside(p, along, length, edge, kUnionRounding, std::tan(kAnyAngle))) {
      beside.push_back(*one);
    }
  }
  std::vector<Stretch> seen;
  if (std::ranges::none_of(beside, &Beside::seen)) return seen;
  const std::vector<double> changes = Changes(beside);
  for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
    const Stretch stretch{std::max(changes[i], 0.0), std::min(changes[i + 1], length)};
    if (stretch.begin < stretch.end && OutermostSeen(beside, 0.5 * (stretch.begin + stretch.end))) {
      seen.push_back(stretch);
    }
  }
  return seen;
}

std::vector<Stretch> StretchesNearSeen(const Eigen::Vector2d& p, const Eigen::Vector2d& along,
                                       double length, std::span<const DirectedEdge> edges, double distance,
                                       double max_angle) {
  std::vector<Stretch> near;
  for (const DirectedEdge& edge : edges) {
    if (!edge.seen) continue;
    const auto beside = RunBeside(p, along, length, edge, distance, std::tan(max_angle));
    if (beside) near.push_back(beside->stretch);
  }
  return near;
}

}  // namespace ariadne::planning
