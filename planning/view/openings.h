#pragma once

#include <span>
#include <vector>

#include "planning/polygon/labelled_polygon.h"

namespace ariadne::planning {

/// For each edge of an area, in the order of EdgesOf, the length of all unseen edges that it is in a row
/// with; 0 for seen ones [m].
std::vector<double> Openings(std::span<const LabelledPolygon> area);

}  // namespace ariadne::planning
