#include "planning/polygon/labelled_union.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "planning/polygon/boundary_labels.h"

namespace ariadne::planning {
namespace {

constexpr double kFiner = 100.0;      // a grid of 1 um: what touches on one of 0.1 mm is not left apart
constexpr double kSpikeWidth = 3e-6;  // what rounding makes of none [m]
constexpr double kLeastPiece = 1e-3;  // what is shorter takes the label of its neighbour [m]

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
void AppendCut(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const std::vector<DirectedEdge>& edges,
               const LabelledUnionOptions& options, LabelledRing& ring) {
  const double length = (q - p).norm();
  const Eigen::Vector2d along = (q - p) / length;
  std::vector<Stretch> stretches = SeenStretches(p, along, length, edges);
  if (options.tolerance > 0.0) {
    std::ranges::copy(StretchesNearSeen(p, along, length, edges, options.tolerance, options.max_angle),
                      std::back_inserter(stretches));
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

LabelledRing Labelled(const slam::Ring& corners, const std::vector<DirectedEdge>& edges,
                      const LabelledUnionOptions& options) {
  LabelledRing ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
    if (next != corners[i]) AppendCut(corners[i], next, edges, options, ring);
  }
  BridgeSteps(ring, std::max(options.tolerance, kUnionRounding));
  return ring;
}

/// Whether a ring runs to b and the same way back.
bool IsSpike(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d there = b - a;
  const Eigen::Vector2d back = c - b;
  if (there.dot(back) >= 0.0) return there == Eigen::Vector2d::Zero() || back == Eigen::Vector2d::Zero();
  const double longer = std::max(there.norm(), back.norm());
  return std::abs(there.x() * back.y() - there.y() * back.x()) < kSpikeWidth * longer;
}

/// Where polygons touch, rounding may leave spikes without width, which would be walls within the area.
slam::Ring WithoutSpikes(slam::Ring ring) {
  for (std::size_t i = 0, unchanged = 0; ring.size() > 2 && unchanged < ring.size();) {
    const std::size_t n = ring.size();
    i %= n;
    if (IsSpike(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n])) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i += ring.size() - 1;  // its neighbours may now be one
      unchanged = 0;
    } else {
      ++i;
      ++unchanged;
    }
  }
  return ring.size() < 3 ? slam::Ring{} : ring;
}

/// Whether a hole is the gap that noise leaves between two polygons. A thin wall is seen, and stays.
bool IsSliver(const LabelledRing& hole, double tolerance) {
  const slam::Polygon2 area = ToPolygon2({hole, {}});
  const double length = slam::Perimeter(area);
  return 2.0 * slam::Area(area) < tolerance * length && SeenLength({hole, {}}) < 0.5 * length;
}

void Scale(slam::Polygon2& area, double factor) {
  for (Eigen::Vector2d& p : area.outer) p *= factor;
  for (slam::Ring& hole : area.holes) {
    for (Eigen::Vector2d& p : hole) p *= factor;
  }
}

void RemoveSpikes(std::vector<slam::Polygon2>& areas) {
  for (slam::Polygon2& area : areas) {
    area.outer = WithoutSpikes(std::move(area.outer));
    for (slam::Ring& hole : area.holes) hole = WithoutSpikes(std::move(hole));
    std::erase_if(area.holes, [](const slam::Ring& hole) { return hole.empty(); });
  }
  std::erase_if(areas, [](const slam::Polygon2& area) { return area.outer.empty(); });
}

/// Twice, because Clipper now and then leaves two areas apart that have an edge in common.
std::vector<slam::Polygon2> FinelyUnited(std::span<const LabelledPolygon> polygons) {
  std::vector<slam::Polygon2> areas;
  for (const LabelledPolygon& polygon : polygons) {
    if (!polygon.empty()) Scale(areas.emplace_back(ToPolygon2(polygon)), kFiner);
  }
  areas = slam::United(slam::United(areas));
  for (slam::Polygon2& area : areas) Scale(area, 1.0 / kFiner);
  RemoveSpikes(areas);
  return areas;
}

}  // namespace

std::vector<LabelledPolygon> LabelledUnion(std::span<const LabelledPolygon> polygons,
                                           const LabelledUnionOptions& options) {
  CheckOptions(options, "labelled_union.");
  for (const LabelledPolygon& polygon : polygons) RequireSimple(polygon);
  const std::vector<DirectedEdge> edges = DirectedEdges(polygons);
  std::vector<LabelledPolygon> united;
  for (const slam::Polygon2& area : FinelyUnited(polygons)) {
    united.push_back({Labelled(area.outer, edges, options), {}});
    for (const slam::Ring& corners : area.holes) {
      LabelledRing hole = Labelled(corners, edges, options);
      if (!IsSliver(hole, options.tolerance)) united.back().holes.push_back(std::move(hole));
    }
  }
  return united;
}

}  // namespace ariadne::planning
