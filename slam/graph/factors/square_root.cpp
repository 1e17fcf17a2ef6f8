#include "slam/graph/factors/square_root.h"

#include <Eigen/Cholesky>
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

template <typename Pose>
typename Pose::Square RootOfInformation(const typename Pose::Square& information) {
  const Eigen::LLT<typename Pose::Square, Eigen::Upper> factor(information);
  if (information.allFinite() && factor.info() == Eigen::Success) return factor.matrixU();
  typename Pose::Square root = Pose::Square::Zero();  // rank-deficient, or an error
  const Eigen::MatrixXd L = SquareRoot(information, "the information matrix of a measurement");
  root.topRows(L.cols()) = L.transpose();
  return root;
}

template Pose2::Square RootOfInformation<Pose2>(const Pose2::Square&);
template Pose3::Square RootOfInformation<Pose3>(const Pose3::Square&);

}  // namespace ariadne::slam
