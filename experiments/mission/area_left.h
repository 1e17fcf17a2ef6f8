#pragma once

#include <span>

#include "planning/polygon/labelled_polygon.h"

namespace ariadne::experiments {

/// Of the edges that nobody has looked behind [m].
double UnseenLength(std::span<const planning::LabelledPolygon> area);

/// Known to be free [m^2].
double FreeArea(std::span<const planning::LabelledPolygon> area);

/// How many more views an area asks for, at a guess: one for each neighbourhood of unseen edges, but for
/// openings shorter than `least` [m]. What lies behind them nobody knows.
int ViewsLeft(std::span<const planning::LabelledPolygon> area, double least);

}  // namespace ariadne::experiments
