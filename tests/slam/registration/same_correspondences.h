#pragma once

#include <gmock/gmock.h>

#include "slam/registration/correspondences.h"

namespace ariadne::slam {

/// The same pairs at the same distances, to the last bit.
MATCHER_P(SameCorrespondences, expected, "") {
  if (arg.model_index.size() != expected.model_index.size()) return false;
  for (std::size_t i = 0; i < expected.model_index.size(); ++i) {
    const bool paired = expected.model_index[i] != kNoPoint;
    if (arg.model_index[i] == expected.model_index[i] &&
        (!paired || arg.squared_distance[i] == expected.squared_distance[i])) {
      continue;
    }
    *result_listener << "data point " << i << " goes with " << arg.model_index[i] << " at "
                     << arg.squared_distance[i] << ", not with " << expected.model_index[i] << " at "
                     << expected.squared_distance[i];
    return false;
  }
  return true;
}

}  // namespace ariadne::slam
