#pragma once

#include <vector>

#include "slam/geometry/polygon2.h"

namespace ariadne::planning {

/// A corner, and what is known of the edge from here to the next corner: `seen`, the scanner found a
/// surface there; otherwise the edge only joins what was found, and unexplored space may lie beyond it.
struct LabelledCorner {
  Eigen::Vector2d p_map = Eigen::Vector2d::Zero();  // [m]
  bool seen = false;
};

/// Corners in order; the last is joined to the first.
using LabelledRing = std::vector<LabelledCorner>;

/// What is known to be free at a height (Sec. 4.2 step 3), in the map frame. The outer ring runs
/// counterclockwise, holes clockwise, so that the area is to the left of each edge. No corners: no area.
struct LabelledPolygon {
  LabelledRing outer;
  std::vector<LabelledRing> holes;

  bool empty() const { return outer.empty(); }
};

/// The same area without labels.
slam::Polygon2 ToPolygon2(const LabelledPolygon& polygon);

/// Length of the edges with one label, those of holes included [m].
double SeenLength(const LabelledPolygon& polygon);
double UnseenLength(const LabelledPolygon& polygon);

/// A disc, as the regular polygon within it, whose edges are unseen: where a robot stands is free, whether
/// it has looked there or not. No radius [m]: an empty polygon.
LabelledPolygon UnseenDisc(const Eigen::Vector2d& center_map, double radius, int corners);

/// True within, and not within a hole.
bool Contains(const LabelledPolygon& polygon, const Eigen::Vector2d& p_map);

/// Throws an Error that names what is wrong with a polygon: a corner that is no place within 100 km, a ring
/// of one or two corners, edges that cross by more than 1 mm. Edges may touch.
void RequireSimple(const LabelledPolygon& polygon);

}  // namespace ariadne::planning
