#pragma once

#include <string>
#include <vector>

#include "experiments/studies/nbv_trials.h"

namespace ariadne::experiments {

/// What can be varied, by name.
const std::vector<std::string>& NbvStudyNames();

/// The ways of planning of one of these, `base` among them in the study of policies. Error for a name that
/// there is not.
std::vector<NbvVariant> NbvVariants(const std::string& study, const ExploreOptions& base);

}  // namespace ariadne::experiments
