#pragma once

#include "experiments/run/run_directory.h"
#include "experiments/studies/plan_step.h"

namespace ariadne::experiments {

/// The next view, what speaks for it, and what is known so far; lengths in m, angles in rad.
Json ToJson(const PlanStep& step);

/// The same in a few lines.
std::string ToText(const PlanStep& step);

}  // namespace ariadne::experiments
