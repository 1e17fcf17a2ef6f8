#pragma once

#include "experiments/report/plan_picture.h"
#include "experiments/studies/plan_step.h"

namespace ariadne::experiments {

// A step of planning in pictures `width` pixels wide.

/// What is known and where to go: the area, its edges, the candidates, the way, the view and its rays.
Image PlanPicture(const PlanStep& step, const PlanStepOptions& options, int width, std::string_view title);

/// Fig. 6: points, lines, polygon, how lines are sorted, candidates, the chosen pose; of the last scan.
std::vector<Image> PlanningPanels(const PlanStep& step, const PlanStepOptions& options, int width);

/// The same plan in layers, dashes included, for SVG.
slam::Drawing DrawingOf(const PlanStep& step, const PlanStepOptions& options);

/// What the colours of these pictures mean.
std::vector<LegendEntry> PlanLegend();

}  // namespace ariadne::experiments
