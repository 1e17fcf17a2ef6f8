#pragma once

#include <Eigen/Core>

namespace ariadne::slam {

/// L of a symmetric positive semidefinite matrix M = L L^T, with as many columns as M has rank. M is first
/// scaled to a unit diagonal, so that small entries keep their digits beside large ones. Error where M is
/// not finite, or has a negative eigenvalue that is more than rounding; `of` says in it what M is.
Eigen::MatrixXd SquareRoot(const Eigen::MatrixXd& matrix, const char* of);

}  // namespace ariadne::slam
