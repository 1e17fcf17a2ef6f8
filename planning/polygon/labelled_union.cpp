#include "planning/polygon/labelled_union.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ariadne::planning {
namespace {

constexpr double kRounding = 3e-4;    // corners and crossings are on a grid of 0.1 mm [m]
constexpr double kAnyAngle = 0.8;     // within the rounding, an edge lies along a boundary up to here [rad]
constexpr double kLeastPiece = 1e-3;  // what is shorter takes the label of its neighbour [m]

struct SeenEdge {
  Eigen::Vector2d from, to;
};

/// A part of an edge, in metres from its first corner.
struct Stretch {
  double begin, end;
};

void AppendSeen(const LabelledRing& ring, bool is_hole, std::vector<SeenEdge>& seen) {
  const bool clockwise = slam::SignedArea(ToPolygon2({ring, {}}).outer) < 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!ring[i].seen) continue;
    const Eigen::Vector2d& from = ring[i].p_map;
    const Eigen::Vector2d& to = ring[(i + 1) % ring.size()].p_map;
    seen.push_back(clockwise == is_hole ? SeenEdge{from, to} : SeenEdge{to, from});
  }
}

std::vector<SeenEdge> SeenEdges(std::span<const LabelledPolygon> polygons) {
  std::vector<SeenEdge> seen;
  for (const LabelledPolygon& polygon : polygons) {
    AppendSeen(polygon.outer, false, seen);
    for (const LabelledRing& hole : polygon.holes) AppendSeen(hole, true, seen);
  }
  return seen;
}

/// Where the edge from p along the unit vector runs beside a seen edge, up to `distance` from it.
std::optional<Stretch> Beside(const Eigen::Vector2d& p, const Eigen::Vector2d& along, double length,
                              const SeenEdge& seen, double distance, double max_angle) {
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d run = seen.to - seen.from;
  const double advance = along.dot(run);
  if (advance <= 0.0 || std::abs(across.dot(run)) > std::tan(max_angle) * advance) return {};
  const double start = along.dot(seen.from - p);
  const double slope = across.dot(run) / advance;
  const double offset = across.dot(seen.from - p);  // at `start`
  Stretch stretch{std::max(start, 0.0), std::min(start + advance, length)};
  if (std::abs(slope) * advance < 1e-12) {
    if (std::abs(offset) > distance) return {};
  } else {
    const double center = start - offset / slope;  // where the two lines meet
    stretch.begin = std::max(stretch.begin, center - distance / std::abs(slope));
    stretch.end = std::min(stretch.end, center + distance / std::abs(slope));
  }
  if (stretch.begin >= stretch.end) return {};
  return stretch;
}

/// Ascending, without overlaps and without gaps shorter than a piece may be.
std::vector<Stretch> Joined(std::vector<Stretch> stretches) {
  std::ranges::sort(stretches, {}, &Stretch::begin);
  std::vector<Stretch> joined;
  for (const Stretch& stretch : stretches) {
    if (joined.empty() || stretch.begin - joined.back().end > kLeastPiece) {
      joined.push_back(stretch);
    } else {
      joined.back().end = std::max(joined.back().end, stretch.end);
    }
  }
  return joined;
}

/// The edge from p to q, cut where its label changes: the corners without q.
void AppendCut(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const std::vector<SeenEdge>& seen,
               const LabelledUnionOptions& options, LabelledRing& ring) {
  const double length = (q - p).norm();
  const Eigen::Vector2d along = (q - p) / length;
  std::vector<Stretch> stretches;
  for (const SeenEdge& edge : seen) {
    if (const auto exact = Beside(p, along, length, edge, kRounding, kAnyAngle))
      stretches.push_back(*exact);
    if (options.tolerance <= kRounding) continue;
    const auto near = Beside(p, along, length, edge, options.tolerance, options.max_angle);
    if (near) stretches.push_back(*near);
  }
  const double least = std::min(kLeastPiece, 0.5 * length);
  double done = 0.0;
  for (const Stretch& stretch : Joined(std::move(stretches))) {
    if (stretch.end - stretch.begin < least) continue;
    const double begin = stretch.begin - done < least ? done : stretch.begin;
    const double end = length - stretch.end < least ? length : stretch.end;
    if (begin > done) ring.push_back({p + done * along, false});
    ring.push_back({p + begin * along, true});
    done = end;
  }
  if (done < length) ring.push_back({p + done * along, false});
}

/// Unseen runs up to the tolerance between seen edges are steps from one place of a wall to the other.
void BridgeSteps(LabelledRing& ring, double tolerance) {
  const std::size_t n = ring.size();
  const auto length = [&](std::size_t i) { return (ring[(i + 1) % n].p_map - ring[i % n].p_map).norm(); };
  for (std::size_t i = 0; i < n; ++i) {
    if (!ring[i].seen) continue;
    std::size_t end = i + 1;
    double run = 0.0;
    while (end < i + n && !ring[end % n].seen) run += length(end++);
    if (run > tolerance) continue;
    for (std::size_t k = i + 1; k < end; ++k) ring[k % n].seen = true;
  }
}

LabelledRing Labelled(const slam::Ring& corners, const std::vector<SeenEdge>& seen,
                      const LabelledUnionOptions& options) {
  LabelledRing ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
    if (next != corners[i]) AppendCut(corners[i], next, seen, options, ring);
  }
  BridgeSteps(ring, std::max(options.tolerance, kRounding));
  return ring;
}

/// Whether a hole is the gap that noise leaves between two polygons. A thin wall is seen, and stays.
bool IsSliver(const LabelledRing& hole, double tolerance) {
  const slam::Polygon2 area = ToPolygon2({hole, {}});
  const double length = slam::Perimeter(area);
  return 2.0 * slam::Area(area) < tolerance * length && SeenLength({hole, {}}) < 0.5 * length;
}

}  // namespace

std::vector<LabelledPolygon> LabelledUnion(std::span<const LabelledPolygon> polygons,
                                           const LabelledUnionOptions& options) {
  CheckOptions(options, "labelled_union.");
  std::vector<slam::Polygon2> areas;
  for (const LabelledPolygon& polygon : polygons) {
    RequireSimple(polygon);
    if (!polygon.empty()) areas.push_back(ToPolygon2(polygon));
  }
  const std::vector<SeenEdge> seen = SeenEdges(polygons);
  std::vector<LabelledPolygon> united;
  for (const slam::Polygon2& area : slam::United(areas)) {
    united.push_back({Labelled(area.outer, seen, options), {}});
    for (const slam::Ring& corners : area.holes) {
      LabelledRing hole = Labelled(corners, seen, options);
      if (!IsSliver(hole, options.tolerance)) united.back().holes.push_back(std::move(hole));
    }
  }
  return united;
}

}  // namespace ariadne::planning
