#pragma once

#include <Eigen/Core>
#include <array>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// A guess of a pose as six pairs of points, in opposite directions from the data's origin, which is where
/// the scanner is: together they are least at the guess, and grow alike in all directions, as the squared
/// distance of a point `length` [m] away does with an angle.
struct GuessPairs {
  std::array<Eigen::Vector3d, 6> data;
  std::array<Eigen::Vector3d, 6> model;
};

GuessPairs PairsOfGuess(const Pose3& T_model_data_guess, double length);

}  // namespace ariadne::slam
