#pragma once

#include <span>

#include "planning/polygon/labelled_polygon.h"
#include "slam/base/options.h"

namespace ariadne::planning {

struct LabelledUnionOptions {
  double tolerance = 0.1;
  double max_angle = 0.09;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "tolerance", self.tolerance, Unit("m"), Range{0.0, 1.0},
        "a boundary this near to a seen edge, and along it, is seen; shorter unseen edges between seen "
        "ones are steps of the same wall. Above what 3 cm and 1 degree of error move a wall 4 m away, far "
        "below a door; 0: exact");
    visit("max_angle", self.max_angle, Unit("rad"), Range{0.0, 0.5},
          "between that boundary and that edge; above the poses' errors (twice 1 degree) and the lines'");
  }
};

/// The areas that any of the polygons covers (Sec. 4.3; Vatti's algorithm), with labels. A piece of the
/// boundary is seen where a seen edge of any polygon lies along it, with the area on the same side: seen
/// wins where both lie on each other. Corners are rounded to 1 micrometre; pieces below 1 mm may take the
/// label of their neighbour.
///
/// Noise of registration puts the same wall into two places, and the outer one of the two edges, which
/// becomes the boundary, may be the unseen one; hence the tolerance. It moves no corner: an opening loses
/// at most the tolerance at its ends. Holes thinner than the tolerance without a seen half are filled.
///
/// Error where a polygon is not simple (RequireSimple) or an option is out of its range.
std::vector<LabelledPolygon> LabelledUnion(std::span<const LabelledPolygon> polygons,
                                           const LabelledUnionOptions& options = {});

}  // namespace ariadne::planning
