#pragma once

#include <string>
#include <vector>

#include "slam/mapper.h"

namespace ariadne::experiments {

/// The ways of matching that are compared, by name: those of registration.method, and "edges": pairwise
/// matching of the end points of lines, point to point, as in Fig. 4c.
std::vector<std::string> MatchingWays();

/// The options, changed to match in that way. Error with the names that exist.
slam::MapperOptions MatchedBy(const std::string& way, slam::MapperOptions options);

}  // namespace ariadne::experiments
