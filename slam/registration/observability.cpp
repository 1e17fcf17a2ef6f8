#include "slam/registration/observability.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

namespace ariadne::slam {

std::string Observability::DescribeDegenerate() const {
  std::string text;
  for (int i = 0; i < degenerate; ++i) {
    const Eigen::Vector3d move = directions.col(i).head<3>();
    const Eigen::Vector3d turn = directions.col(i).tail<3>();
    const bool moves = move.norm() >= turn.norm();
    const Eigen::Vector3d axis = (moves ? move : turn).normalized();
    text += fmt::format("{}{} ({:.2f}, {:.2f}, {:.2f})", i > 0 ? ", " : "",
                        moves ? "moves along" : "turns about", axis.x(), axis.y(), axis.z());
  }
  return text;
}

Observability ObserveMotions(const Pose3::Square& sum, std::size_t count, double min_share) {
  Observability observability;
  observability.degenerate = Pose3::kDof;
  if (count == 0) return observability;
  const Eigen::SelfAdjointEigenSolver<Pose3::Square> solver(sum / static_cast<double>(count));
  observability.shares = solver.eigenvalues();
  observability.directions = solver.eigenvectors();
  observability.degenerate = static_cast<int>((solver.eigenvalues().array() < min_share).count());
  return observability;
}

}  // namespace ariadne::slam
