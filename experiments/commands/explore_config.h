#pragma once

#include <string>
#include <vector>

#include "experiments/studies/explore.h"

namespace ariadne::experiments {

/// The options of an exploration from a file (none where it is empty) and assignments. Error where the file
/// is of another experiment.
ExploreStudyOptions ResolveExploreOptions(const std::string& config,
                                          const std::vector<std::string>& assignments);

}  // namespace ariadne::experiments
