#pragma once

#include "slam/matching/match_context.h"

namespace ariadne::slam {

/// Aligns the new scan to the earlier ones that overlap it most, one by one, and moves all scans to where
/// these and all earlier alignments agree best (a relative-pose graph).
MatchResult MatchByGraph(const MatchContext& c);

/// Looks for closures of the new scan (loop_closure.h), and moves all scans to the graph's optimum where
/// one was found. Returns whether.
bool CloseLoops(const MatchContext& c, MatchResult& result);

}  // namespace ariadne::slam
