#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// L of a symmetric positive semidefinite matrix M = L L^T, with as many columns as M has rank. M is first
/// scaled to a unit diagonal, so that small entries keep their digits beside large ones. Error where M is
/// not finite, or has a negative eigenvalue that is more than rounding; `of` says in it what M is.
Eigen::MatrixXd SquareRoot(const Eigen::MatrixXd& matrix, const char* of);

/// U of information = U^T U, so that |U e|^2 = e^T information e. Error where the information is not
/// positive semidefinite: the squared error is no sum of squares then.
template <typename Pose>
typename Pose::Square RootOfInformation(const typename Pose::Square& information);

}  // namespace ariadne::slam
