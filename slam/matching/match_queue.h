#pragma once

#include "slam/matching/match_context.h"

namespace ariadne::slam {

/// Sec. 3.2, simultaneous matching: steps 1 (pairwise start), 2 and 3 (the queue).
MatchResult MatchByQueue(const MatchContext& c);

}  // namespace ariadne::slam
