#pragma once

#include <vector>

#include "experiments/render/frame.h"
#include "experiments/render/splats.h"

namespace ariadne::experiments {

/// Draws the splats over what the frame holds. Discs that lie within each other's radius in depth belong to
/// one surface: their colours and depths blend, so that the surface is smooth and scans that cover the same
/// wall mix instead of flickering. What is behind the nearest surface is hidden.
void DrawSplats(Frame& frame, const std::vector<Splat>& splats);

}  // namespace ariadne::experiments
