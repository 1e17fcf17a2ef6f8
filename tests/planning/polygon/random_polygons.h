#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "planning/polygon/labelled_polygon.h"
#include "slam/base/random.h"
#include "slam/geometry/pose2.h"

/// Random inputs of labelled unions, their corners whole numbers of 0.1 mm.
namespace ariadne::planning {

/// A rectangle whose edges (below, right, above, left) have these labels.
inline LabelledPolygon Rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                                 const std::array<bool, 4>& seen) {
  return {{{low, seen[0]}, {{high.x(), low.y()}, seen[1]}, {high, seen[2]}, {{low.x(), high.y()}, seen[3]}},
          {}};
}

inline LabelledPolygon Moved(const slam::Pose2& T_a_b, LabelledPolygon polygon) {
  for (LabelledCorner& corner : polygon.outer) corner.p_map = T_a_b * corner.p_map;
  for (LabelledRing& hole : polygon.holes) {
    for (LabelledCorner& corner : hole) corner.p_map = T_a_b * corner.p_map;
  }
  return polygon;
}

inline void RoundCorners(LabelledRing& ring) {
  for (LabelledCorner& corner : ring) corner.p_map = (corner.p_map * 1e4).array().round() * 1e-4;
}

inline bool DrawBool(RandomStream& stream) { return DrawUniform(stream, 0.0, 1.0) < 0.5; }

inline LabelledPolygon DrawStar(RandomStream& stream) {
  const Eigen::Vector2d center(DrawUniform(stream, -3.0, 3.0), DrawUniform(stream, -3.0, 3.0));
  const int corners = static_cast<int>(DrawUniform(stream, 3.0, 14.0));
  const double start = DrawUniform(stream, 0.0, std::numbers::pi);
  LabelledPolygon star;
  for (int i = 0; i < corners; ++i) {
    const double bearing = start + 2.0 * std::numbers::pi * i / corners;
    const Eigen::Vector2d u(std::cos(bearing), std::sin(bearing));
    const double radius = DrawUniform(stream, 0.5, 4.0);
    star.outer.push_back({center + radius * u, DrawBool(stream)});
  }
  RoundCorners(star.outer);
  return star;
}

/// On a grid of 1 m, so that edges of several lie on each other; every other one moved by noise.
inline LabelledPolygon DrawRectangle(RandomStream& stream) {
  const auto whole = [&](double low, double high) { return std::floor(DrawUniform(stream, low, high)); };
  const double left = whole(-4.0, 4.0), below = whole(-4.0, 4.0);
  const double right = left + whole(1.0, 4.0), above = below + whole(1.0, 4.0);
  std::array<bool, 4> seen{};
  for (bool& one : seen) one = DrawBool(stream);
  LabelledPolygon rectangle = Rectangle({left, below}, {right, above}, seen);
  if (DrawBool(stream)) return rectangle;
  const double x = DrawNormal(stream, 0.0, 0.03), y = DrawNormal(stream, 0.0, 0.03);
  rectangle = Moved({DrawNormal(stream, 0.0, 0.017), {x, y}}, rectangle);
  RoundCorners(rectangle.outer);
  return rectangle;
}

inline void RoundCorners(LabelledPolygon& polygon) {
  RoundCorners(polygon.outer);
  for (LabelledRing& hole : polygon.holes) RoundCorners(hole);
}

/// Every other round is turned as a whole, so that common edges lie on each other but for the rounding.
inline slam::Pose2 DrawTurn(RandomStream& stream, int round) {
  if (round % 2 == 0) return {};
  return {DrawUniform(stream, 0.0, 7.0), {30.0, -20.0}};
}

/// One to six: by turns only stars, both, and only rectangles.
inline std::vector<LabelledPolygon> DrawPolygons(RandomStream& stream, int round,
                                                 const slam::Pose2& T_map_grid) {
  std::vector<LabelledPolygon> polygons(static_cast<std::size_t>(DrawUniform(stream, 1.0, 7.0)));
  for (LabelledPolygon& polygon : polygons) {
    const bool star = round % 3 == 0 || (round % 3 == 1 && DrawBool(stream));
    polygon = Moved(T_map_grid, star ? DrawStar(stream) : DrawRectangle(stream));
    RoundCorners(polygon);
  }
  return polygons;
}

}  // namespace ariadne::planning
