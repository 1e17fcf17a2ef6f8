#pragma once

#include "slam/registration/align.h"

namespace ariadne::slam {

/// A better start than the guess. Tries starts on a lattice of half the search radius all around the guess,
/// each refined in a few iterations with some 500 of the data points, and returns the one after which these
/// lie nearest to the model. Rotations need no lattice: the basin of the iterations is some 20 degrees
/// wide.
Pose3 FindStart(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
                const AlignOptions& options);

}  // namespace ariadne::slam
