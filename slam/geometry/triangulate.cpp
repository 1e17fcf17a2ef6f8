#include "slam/geometry/triangulate.h"

#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <map>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

namespace bp = boost::polygon;

using Point = bp::point_data<int>;
using Trapezoid = bp::polygon_data<int>;

constexpr double kGrid = 1e-4;     // [m]
constexpr double kFarthest = 1e5;  // that the grid reaches [m]

Point ToGrid(const Eigen::Vector2d& p) {
  if (!(p.array().abs() < kFarthest).all()) Fail("({}, {}) is no corner of a polygon", p.x(), p.y());
  return {static_cast<int>(std::lround(p.x() / kGrid)), static_cast<int>(std::lround(p.y() / kGrid))};
}

Trapezoid ToGrid(const Ring& ring) {
  std::vector<Point> corners;
  for (const Eigen::Vector2d& p : ring) corners.push_back(ToGrid(p));
  return {corners.begin(), corners.end()};
}

bp::polygon_set_data<int> AreaOf(std::span<const Polygon2> polygons) {
  bp::polygon_set_data<int> area;
  for (const Polygon2& polygon : polygons) {
    area.insert(ToGrid(polygon.outer));
    for (const Ring& hole : polygon.holes) area.insert(ToGrid(hole), true);
  }
  return area;
}

/// Vertices by their place on the grid.
class Vertices {
 public:
  std::uint32_t IndexOf(const Point& p) {
    const auto [found, is_new] =
        index_.try_emplace({p.x(), p.y()}, static_cast<std::uint32_t>(all_.size()));
    if (is_new) all_.emplace_back(p.x() * kGrid, p.y() * kGrid);
    return found->second;
  }
  std::vector<Eigen::Vector2d> Take() { return std::move(all_); }

 private:
  std::map<std::pair<int, int>, std::uint32_t> index_;
  std::vector<Eigen::Vector2d> all_;
};

bool IsCounterclockwise(const Point& a, const Point& b, const Point& c) {
  const auto difference = [](int to, int from) { return static_cast<double>(to) - from; };
  return difference(b.x(), a.x()) * difference(c.y(), a.y()) >
         difference(b.y(), a.y()) * difference(c.x(), a.x());
}

}  // namespace

Triangles2 Triangulated(std::span<const Polygon2> polygons) {
  std::vector<Trapezoid> trapezoids;
  AreaOf(polygons).get_trapezoids(trapezoids);
  Triangles2 result;
  Vertices vertices;
  for (const Trapezoid& trapezoid : trapezoids) {
    std::vector<Point> corners(trapezoid.begin(), trapezoid.end());
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Point &a = corners[0], &b = corners[i - 1], &c = corners[i];
      const bool is_left = IsCounterclockwise(a, b, c);
      if (!is_left && !IsCounterclockwise(a, c, b)) continue;  // without area
      const std::uint32_t ia = vertices.IndexOf(a), ib = vertices.IndexOf(b), ic = vertices.IndexOf(c);
      result.triangles.push_back(is_left ? std::array{ia, ib, ic} : std::array{ia, ic, ib});
    }
  }
  result.vertices = vertices.Take();
  return result;
}

}  // namespace ariadne::slam
