#include "experiments/bench/stock_ceres.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <vector>

namespace ariadne::bench {
namespace {

using slam::Pose2;
using slam::Pose3;

template <typename Pose>
typename Pose::Square Root(const typename Pose::Square& information) {
  return information.llt().matrixU();
}

struct Error3 {
  Pose3 T_from_to;
  Pose3::Square root;

  template <typename T>
  bool operator()(const T* p_from, const T* q_from, const T* p_to, const T* q_to, T* residuals) const {
    using Vector3 = Eigen::Matrix<T, 3, 1>;
    using Quaternion = Eigen::Quaternion<T>;
    const Quaternion inverse = Eigen::Map<const Quaternion>(q_from).conjugate();
    const Vector3 way = Eigen::Map<const Vector3>(p_to) - Eigen::Map<const Vector3>(p_from);
    const Quaternion off =
        T_from_to.rotation.conjugate().template cast<T>() * (inverse * Eigen::Map<const Quaternion>(q_to));
    const Vector3 off_way = inverse * way - T_from_to.translation.template cast<T>();
    Eigen::Matrix<T, 6, 1> error;
    error << T_from_to.rotation.conjugate().template cast<T>() * off_way, T(2.0) * off.vec();
    Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(residuals);
    weighted = root.template cast<T>() * error;
    return true;
  }
};

struct Error2 {
  Pose2 T_from_to;
  Pose2::Square root;
  bool chord;

  template <typename T>
  bool operator()(const T* from, const T* to, T* residuals) const {
    using std::atan2, std::cos, std::sin;
    const T angle = from[2] + T(T_from_to.angle);
    const T x = to[0] - from[0], y = to[1] - from[1];
    const T off = to[2] - angle;
    const Eigen::Vector2d t = T_from_to.RotationMatrix().transpose() * T_from_to.translation;
    Eigen::Matrix<T, 3, 1> error;
    error << cos(angle) * x + sin(angle) * y - T(t.x()), cos(angle) * y - sin(angle) * x - T(t.y()),
        chord ? T(2.0) * sin(T(0.5) * off) : atan2(sin(off), cos(off));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> weighted(residuals);
    weighted = root.template cast<T>() * error;
    return true;
  }
};

void Solve(ceres::Problem& problem) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

}  // namespace

double OptimizeWithStockCeres(const slam::PoseGraph2& graph) {
  std::vector<std::array<double, 3>> poses;
  for (const auto& node : graph.nodes)
    poses.push_back(
        {node.T_map_node.translation.x(), node.T_map_node.translation.y(), node.T_map_node.angle});
  ceres::Problem problem;
  for (const auto& edge : graph.edges) {
    auto* error = new Error2{edge.T_from_to, Root<Pose2>(edge.information),
                             graph.rotation_error == slam::RotationError::kChord};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Error2, 3, 3, 3>(error), nullptr,
                             poses[edge.from].data(), poses[edge.to].data());
  }
  problem.SetParameterBlockConstant(poses[0].data());
  Solve(problem);
  slam::PoseGraph2 result = graph;
  for (std::size_t n = 0; n < poses.size(); ++n)
    result.nodes[n].T_map_node = {poses[n][2], {poses[n][0], poses[n][1]}};
  return slam::Objective(result);
}

double OptimizeWithStockCeres(const slam::PoseGraph3& graph) {
  slam::PoseGraph3 result = graph;
  std::vector<slam::PoseNode<Pose3>>& nodes = result.nodes;
  const auto p = [&](std::size_t n) { return nodes[n].T_map_node.translation.data(); };
  const auto q = [&](std::size_t n) { return nodes[n].T_map_node.rotation.coeffs().data(); };
  ceres::Problem problem;
  for (const auto& edge : graph.edges) {
    auto* error = new Error3{edge.T_from_to, Root<Pose3>(edge.information)};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Error3, 6, 3, 4, 3, 4>(error), nullptr,
                             p(edge.from), q(edge.from), p(edge.to), q(edge.to));
  }
  for (std::size_t n = 0; n < nodes.size(); ++n)
    problem.SetManifold(q(n), new ceres::EigenQuaternionManifold);
  problem.SetParameterBlockConstant(p(0));
  problem.SetParameterBlockConstant(q(0));
  Solve(problem);
  return slam::Objective(result);
}

}  // namespace ariadne::bench
