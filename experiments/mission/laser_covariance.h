#pragma once

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// The covariance of the laser's pose, in its tangent space, on a robot whose pose on the floor has this
/// covariance in its own. A wheeled robot does not leave the floor: what is not seen from above is as
/// certain as the floor is even, with sigmas floor_height [m] of its height and floor_tilt [rad] about
/// level axes.
slam::Pose3::Square LaserCovariance(const slam::Pose2::Square& covariance_base,
                                    const slam::Pose3& T_base_laser, double floor_height,
                                    double floor_tilt);

}  // namespace ariadne::experiments
