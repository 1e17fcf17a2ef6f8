#pragma once

#include <cstdint>

#include "planning/polygon/labelled_polygon.h"

namespace ariadne::experiments {

/// A building of 30 x 20 m, six blocks of rooms between which corridors run, as a planner sees it when its
/// outline has been found in about `pieces` pieces, one in five of them unseen. For measuring times.
planning::LabelledPolygon PiecedBuilding(int pieces, std::uint64_t seed);

}  // namespace ariadne::experiments
