#pragma once

#include "experiments/report/plan_picture.h"

namespace ariadne::experiments {

/// How lines are put in order (Sec. 4.2 step 3): three of a scan's lines that follow each other, and the
/// smallest angles between their ends as the scanner sees them. Without three lines only the scanner.
Image SortingPicture(const planning::LabelledPolygon& polygon, const slam::Pose2& T_map_scan, int width,
                     std::string_view title);

}  // namespace ariadne::experiments
