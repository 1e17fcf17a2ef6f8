#pragma once

#include "slam/matching/match_context.h"

namespace ariadne::slam {

/// Aligns the new scan to all that it overlaps, and looks for closures; after one, and every so many scans,
/// does what FinishJointly() does.
MatchResult MatchJointly(const MatchContext& c);

/// Makes all scans agree with each other at once, by all point pairs between them (joint_solve.h).
MatchResult FinishJointly(const MatchContext& c);

}  // namespace ariadne::slam
