#pragma once

#include <vector>

#include "planning/view/edge_set.h"
#include "slam/base/random.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

inline slam::Ring Rectangle(double x0, double y0, double x1, double y1, bool is_hole = false) {
  if (is_hole) return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// A hall of 20 x 12 m with three pillars.
inline slam::Polygon2 Hall() {
  return {Rectangle(0.0, 0.0, 20.0, 12.0),
          {Rectangle(4.0, 3.0, 6.0, 7.0, true), Rectangle(9.0, 8.0, 9.5, 8.5, true),
           Rectangle(12.0, 2.0, 17.0, 4.0, true)}};
}

/// The edges of the hall in pieces of random length and label.
inline std::vector<Edge> LabelledHall(std::uint64_t seed, double longest = 1.5) {
  RandomStream stream = NamedStream(seed, "simple_room");
  std::vector<Edge> pieces;
  for (const Edge& edge : EdgesOf(Hall(), true)) {
    Eigen::Vector2d from = edge.from;
    while ((edge.to - from).norm() > longest) {
      const Eigen::Vector2d to = from + DrawUniform(stream, 0.1, longest) * (edge.to - from).normalized();
      pieces.push_back({from, to, DrawUniform(stream, 0.0, 1.0) < 0.6});
      from = to;
    }
    pieces.push_back({from, edge.to, true});
  }
  return pieces;
}

inline std::vector<Edge> Moved(const slam::Pose2& T_new_old, std::vector<Edge> edges) {
  for (Edge& edge : edges) edge.from = T_new_old * edge.from, edge.to = T_new_old * edge.to;
  return edges;
}

}  // namespace ariadne::planning
