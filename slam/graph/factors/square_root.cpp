#include "slam/graph/factors/square_root.h"

#include <Eigen/Eigenvalues>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr double kRounding = 1e-15;  // eigenvalues below it, of the scaled matrix and per row, are none
constexpr double kIndefinite = 1e-9;

}  // namespace

Eigen::MatrixXd SquareRoot(const Eigen::MatrixXd& matrix, const char* of) {
  if (!matrix.allFinite()) Fail("{} has a number that is not finite", of);
  const Eigen::VectorXd scale = matrix.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd inverse = scale.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 1.0; });
  const Eigen::MatrixXd scaled = inverse.asDiagonal() * matrix * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);  // ascending eigenvalues
  const Eigen::VectorXd& values = solver.eigenvalues();
  const Eigen::Index size = matrix.rows();
  if (values(0) < -kIndefinite * std::max(1.0, values(size - 1)))
    Fail("{} is not positive semidefinite: its scaled least eigenvalue is {:.3g}", of, values(0));
  const auto rank = (values.array() > kRounding * static_cast<double>(size)).count();
  return scale.asDiagonal() * solver.eigenvectors().rightCols(rank) *
         values.tail(rank).cwiseSqrt().asDiagonal();
}

}  // namespace ariadne::slam
