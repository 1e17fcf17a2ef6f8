#include "slam/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr double kGrid = 1e-4;     // [m]
constexpr double kFarthest = 1e5;  // that the grid reaches [m]

/// On the grid.
struct Corner {
  std::int64_t x = 0, y = 0;
};

/// Of a ring, not level. Who crosses it towards +x is in so many rings more than before.
struct Side {
  Corner low, high;
  int more = 0;

  double XAt(double y) const {
    const auto rise = static_cast<double>(high.y - low.y), run = static_cast<double>(high.x - low.x);
    return static_cast<double>(low.x) + run * (y - static_cast<double>(low.y)) / rise;
  }
  Corner At(std::int64_t y) const { return {std::llround(XAt(static_cast<double>(y))), y}; }
};

/// Between two sides, from one height to another.
struct Trapezoid {
  const Side *left, *right;
  std::int64_t low = 0, high = 0;
};

Corner ToGrid(const Eigen::Vector2d& p) {
  if (!(p.array().abs() < kFarthest).all()) Fail("({}, {}) is no corner of a polygon", p.x(), p.y());
  return {std::llround(p.x() / kGrid), std::llround(p.y() / kGrid)};
}

void AddSides(const Ring& ring, bool is_hole, std::vector<Side>& sides) {
  const int inward = (SignedArea(ring) > 0.0) != is_hole ? 1 : -1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner from = ToGrid(ring[i]), to = ToGrid(ring[(i + 1) % ring.size()]);
    if (from.y > to.y) sides.push_back({to, from, inward});
    if (from.y < to.y) sides.push_back({from, to, -inward});
  }
}

/// The sides of all rings, by where they begin.
std::vector<Side> SidesOf(std::span<const Polygon2> polygons) {
  std::vector<Side> sides;
  for (const Polygon2& polygon : polygons) {
    AddSides(polygon.outer, false, sides);
    for (const Ring& hole : polygon.holes) AddSides(hole, true, sides);
  }
  std::ranges::stable_sort(sides, {}, [](const Side& side) { return side.low.y; });
  return sides;
}

/// What of a band without corners is inside, from left to right.
std::vector<Trapezoid> InsideOf(std::span<const Side* const> across, std::int64_t low, std::int64_t high) {
  std::vector<Trapezoid> inside;
  int rings = 0;
  const Side* left = nullptr;
  for (const Side* side : across) {
    const int before = std::exchange(rings, rings + side->more);
    if (before <= 0 && rings > 0) left = side;
    if (before > 0 && rings <= 0) inside.push_back({left, side, low, high});
  }
  return inside;
}

/// From below to above, band by band; what goes on between the same two sides is one.
std::vector<Trapezoid> TrapezoidsBetween(std::span<const Side> sides) {
  std::vector<std::int64_t> heights;
  for (const Side& side : sides) heights.insert(heights.end(), {side.low.y, side.high.y});
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<Trapezoid> done;
  std::map<const Side*, Trapezoid> open;  // by their left sides, which lie in one array
  std::vector<const Side*> across;
  auto next = sides.begin();
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const std::int64_t low = heights[i], high = heights[i + 1];
    std::erase_if(across, [&](const Side* side) { return side->high.y <= low; });
    for (; next != sides.end() && next->low.y <= low; ++next) across.push_back(&*next);
    const double middle = 0.5 * static_cast<double>(low + high);
    std::ranges::stable_sort(across, {}, [&](const Side* side) { return side->XAt(middle); });
    std::map<const Side*, Trapezoid> now;
    for (Trapezoid& inside : InsideOf(across, low, high)) {
      const auto before = open.find(inside.left);
      if (before != open.end() && before->second.right == inside.right) {
        inside.low = before->second.low;
        open.erase(before);
      }
      now.emplace(inside.left, inside);
    }
    for (const auto& [left, ended] : open) done.push_back(ended);
    open = std::move(now);
  }
  for (const auto& [left, ended] : open) done.push_back(ended);
  return done;
}

/// Vertices by their place on the grid.
class Vertices {
 public:
  std::uint32_t IndexOf(const Corner& p) {
    const auto [found, is_new] = index_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(all_.size()));
    if (is_new) all_.emplace_back(static_cast<double>(p.x) * kGrid, static_cast<double>(p.y) * kGrid);
    return found->second;
  }
  std::vector<Eigen::Vector2d> Take() { return std::move(all_); }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> index_;
  std::vector<Eigen::Vector2d> all_;
};

bool IsCounterclockwise(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
}

}  // namespace

Triangles2 Triangulated(std::span<const Polygon2> polygons) {
  const std::vector<Side> sides = SidesOf(polygons);
  Triangles2 result;
  Vertices vertices;
  for (const auto& [left, right, low, high] : TrapezoidsBetween(sides)) {
    const std::array corners{left->At(low), right->At(low), right->At(high), left->At(high)};
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Corner &a = corners[0], &b = corners[i - 1], &c = corners[i];
      if (!IsCounterclockwise(a, b, c)) continue;  // without area
      result.triangles.push_back({vertices.IndexOf(a), vertices.IndexOf(b), vertices.IndexOf(c)});
    }
  }
  result.vertices = vertices.Take();
  return result;
}

}  // namespace ariadne::slam
