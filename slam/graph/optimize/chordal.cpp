#include "slam/graph/optimize/chordal.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

#include "slam/base/error.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/optimize/variables.h"
#include "slam/sparse/block_cholesky.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
constexpr int kDimension = Pose::Point::RowsAtCompileTime;
template <typename Pose>
using Rotation = Eigen::Matrix<double, kDimension<Pose>, kDimension<Pose>>;

template <typename Pose>
IsotropicWeights SafeWeights(const typename Pose::Square& information) {
  constexpr int d = kDimension<Pose>;
  if (Eigen::LLT<typename Pose::Square>(information).info() == Eigen::Success)
    return IsotropicWeightsOf(information);
  const double tau = information.template topLeftCorner<d, d>().trace() / d;
  const double kappa = information.template bottomRightCorner<Pose::kDof - d, Pose::kDof - d>().trace();
  return {std::max(kappa, 1e-9), std::max(tau, 1e-9)};
}

Eigen::Matrix2d NearestRotation(const Eigen::Matrix2d& m) {
  return Pose2{std::atan2(m(1, 0) - m(0, 1), m(0, 0) + m(1, 1)), {}}.RotationMatrix();
}

/// By the singular value decomposition, which serves every matrix.
Eigen::Matrix3d NearestRotationBySvd(const Eigen::Matrix3d& m) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
}

/// By Newton's iteration for the polar decomposition, R <- (R + R^-T) / 2, which takes a few steps where
/// the matrix is almost a rotation, as most are.
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& m) {
  constexpr int kMaxSteps = 8;
  Eigen::Matrix3d R = m;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double determinant = R.determinant();
    if (!(determinant > 1e-3)) break;
    Eigen::Matrix3d cofactors;  // R^-T determinant
    cofactors << R.col(1).cross(R.col(2)), R.col(2).cross(R.col(0)), R.col(0).cross(R.col(1));
    const Eigen::Matrix3d next = 0.5 * (R + cofactors / determinant);
    const double change = (next - R).squaredNorm();
    R = next;
    if (change < 1e-20) return R;
  }
  return NearestRotationBySvd(m);
}

void SetRotation(Pose2& pose, const Eigen::Matrix2d& R) { pose.angle = std::atan2(R(1, 0), R(0, 0)); }
void SetRotation(Pose3& pose, const Eigen::Matrix3d& R) {
  pose.rotation = Eigen::Quaterniond(R).normalized();
}

/// A least-squares problem over the nodes with one square block per node and kRight right sides. Each edge
/// asks for X_to = A X_from + B, with a weight.
template <typename Pose, int kBlock, int kRight>
class LinearProblem {
 public:
  using Square = Eigen::Matrix<double, kBlock, kBlock>;
  using Value = Eigen::Matrix<double, kBlock, kRight>;

  explicit LinearProblem(const GraphVariables& variables)
      : variables_(variables), H_(kBlock, variables.order, variables.places), b_(H_.size(), kRight) {
    b_.setZero();
  }

  /// `fixed` is the value of the node that is no variable, if one is.
  void AddEdge(const PoseEdge<Pose>& edge, double weight, const Square& A, const Value& B,
               const std::optional<Value>& from_fixed, const std::optional<Value>& to_fixed) {
    const std::size_t from = variables_.of_node[edge.from], to = variables_.of_node[edge.to];
    if (!from_fixed) {
      H_.template Add<kBlock>(H_.Diagonal(from), weight * A.transpose() * A);
      const Value target = to_fixed ? Value(*to_fixed - B) : Value(-B);
      Right(from) += weight * A.transpose() * target;
    }
    if (!to_fixed) {
      H_.template Add<kBlock>(H_.Diagonal(to), weight * Square::Identity());
      const Value target = from_fixed ? Value(A * *from_fixed + B) : B;
      Right(to) += weight * target;
    }
    if (!from_fixed && !to_fixed) H_.template Add<kBlock>(H_.Find(from, to), -weight * A.transpose());
  }

  void AddPrior(std::size_t variable, double weight, const Value& value) {
    H_.template Add<kBlock>(H_.Diagonal(variable), weight * Square::Identity());
    Right(variable) += weight * value;
  }

  /// Error where the graph leaves something open.
  void Solve() {
    BlockCholesky factor(H_);
    if (!factor.Factorize(H_))
      Fail(
          "the chordal start does not exist: the graph leaves poses open (disconnected, or without "
          "weight)");
    b_ = factor.Solve(b_);
  }

  Value Of(std::size_t variable) const { return b_.template block<kBlock, kRight>(H_.row(variable), 0); }

 private:
  auto Right(std::size_t variable) { return b_.template block<kBlock, kRight>(H_.row(variable), 0); }

  const GraphVariables& variables_;
  BlockMatrix H_;
  Eigen::MatrixXd b_;
};

template <typename Pose>
void SolveRotations(PoseGraph<Pose>& graph, const GraphVariables& variables,
                    const std::vector<IsotropicWeights>& weights) {
  using R = Rotation<Pose>;
  constexpr int d = kDimension<Pose>;
  LinearProblem<Pose, d, d> problem(variables);  // of R^T: R_to^T = R_from_to^T R_from^T
  const auto fixed = [&](std::size_t node) -> std::optional<R> {
    if (variables.of_node[node] != GraphVariables::kFixed) return {};
    return R(graph.nodes[node].T_map_node.RotationMatrix().transpose());
  };
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const PoseEdge<Pose>& edge = graph.edges[k];
    problem.AddEdge(edge, weights[k].kappa, edge.T_from_to.RotationMatrix().transpose(), R::Zero(),
                    fixed(edge.from), fixed(edge.to));
  }
  for (const PosePrior<Pose>& prior : graph.priors) {
    const std::size_t variable = variables.of_node[prior.node];
    if (variable == GraphVariables::kFixed) continue;
    problem.AddPrior(variable, SafeWeights<Pose>(prior.information).kappa,
                     prior.T_map_node.RotationMatrix().transpose());
  }
  problem.Solve();
  for (std::size_t v = 0; v < variables.node_of.size(); ++v) {
    SetRotation(graph.nodes[variables.node_of[v]].T_map_node,
                NearestRotation(R(problem.Of(v).transpose())));
  }
}

template <typename Pose>
void SolveTranslations(PoseGraph<Pose>& graph, const GraphVariables& variables,
                       const std::vector<IsotropicWeights>& weights) {
  constexpr int d = kDimension<Pose>;
  using Row = Eigen::Matrix<double, 1, d>;
  LinearProblem<Pose, 1, d> problem(variables);
  const auto fixed = [&](std::size_t node) -> std::optional<Row> {
    if (variables.of_node[node] != GraphVariables::kFixed) return {};
    return Row(graph.nodes[node].T_map_node.translation.transpose());
  };
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const PoseEdge<Pose>& edge = graph.edges[k];
    const Row step =
        (graph.nodes[edge.from].T_map_node.RotationMatrix() * edge.T_from_to.translation).transpose();
    problem.AddEdge(edge, weights[k].tau, Eigen::Matrix<double, 1, 1>::Identity(), step, fixed(edge.from),
                    fixed(edge.to));
  }
  for (const PosePrior<Pose>& prior : graph.priors) {
    const std::size_t variable = variables.of_node[prior.node];
    if (variable == GraphVariables::kFixed) continue;
    problem.AddPrior(variable, SafeWeights<Pose>(prior.information).tau,
                     prior.T_map_node.translation.transpose());
  }
  problem.Solve();
  for (std::size_t v = 0; v < variables.node_of.size(); ++v) {
    graph.nodes[variables.node_of[v]].T_map_node.translation = problem.Of(v).transpose();
  }
}

}  // namespace

template <typename Pose>
void InitializeByChords(PoseGraph<Pose>& graph, const GraphVariables& variables) {
  if (variables.node_of.empty()) return;
  std::vector<IsotropicWeights> weights;
  weights.reserve(graph.edges.size());
  for (const PoseEdge<Pose>& edge : graph.edges) weights.push_back(SafeWeights<Pose>(edge.information));
  SolveRotations(graph, variables, weights);
  SolveTranslations(graph, variables, weights);
}

template void InitializeByChords(PoseGraph2&, const GraphVariables&);
template void InitializeByChords(PoseGraph3&, const GraphVariables&);

}  // namespace ariadne::slam
