#include "slam/graph/optimize/covariance.h"

#include <fmt/format.h>

#include "slam/base/error.h"
#include "slam/graph/optimize/normal_system.h"
#include "slam/graph/structure.h"
#include "slam/sparse/block_cholesky.h"
#include "slam/sparse/selected_inverse.h"

namespace ariadne::slam {
namespace {

/// The columns of the inverse that belong to a variable.
template <int kDof>
Eigen::MatrixXd ColumnsOfInverse(const BlockCholesky& factor, const BlockMatrix& H, std::size_t variable) {
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(H.size(), kDof);
  unit.block<kDof, kDof>(H.row(variable), 0).setIdentity();
  return factor.Solve(unit);
}

/// The covariance of T_a_b = T_map_a^-1 T_map_b from the joint one of both poses: a step of b makes
/// T_a_b Exp(tau), one of a makes T_a_b Exp(-Ad(T_b_a) tau).
template <typename Pose>
typename Pose::Square RelativeCovariance(const Pose& T_a_b, const typename Pose::Square& aa,
                                         const typename Pose::Square& ab, const typename Pose::Square& bb) {
  const typename Pose::Square A = T_a_b.Inverse().Adjoint();
  const typename Pose::Square mixed = A * ab;
  return bb + A * aa * A.transpose() - mixed - mixed.transpose();
}

}  // namespace

template <typename Pose>
GraphCovariances<Pose> MarginalCovariances(const PoseGraph<Pose>& graph,
                                           const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                                           const std::vector<double>& edge_weights) {
  constexpr int kDof = Pose::kDof;
  using Square = typename Pose::Square;
  CheckGraph(graph);
  NormalSystem<Pose> system(graph);
  GraphCovariances<Pose> covariances{std::vector<Square>(graph.nodes.size(), Square::Zero()), {}};
  const GraphVariables& variables = system.variables();
  if (variables.node_of.empty()) {
    covariances.pairs.assign(pairs.size(), Square::Zero());
    return covariances;
  }
  system.Linearize(graph, EdgeWeighting{GraphRobust::kNone, 1.0, edge_weights}, Hessian::kGaussNewton);
  BlockCholesky factor(system.H(), FactorKind::kSupernodal);
  if (!factor.Factorize(system.H()))
    Fail("the poses have no covariance: the edges leave some pose open, or have indefinite information");
  const std::vector<Eigen::MatrixXd> blocks = DiagonalBlocksOfInverse(factor, system.H());
  for (std::size_t v = 0; v < blocks.size(); ++v) covariances.nodes[variables.node_of[v]] = blocks[v];
  for (const auto& [a, b] : pairs) {
    const Pose T_a_b = graph.nodes[a].T_map_node.Inverse() * graph.nodes[b].T_map_node;
    Square ab = Square::Zero();
    const std::size_t variable_a = variables.of_node[a], variable_b = variables.of_node[b];
    if (variable_a != GraphVariables::kFixed && variable_b != GraphVariables::kFixed) {
      ab = ColumnsOfInverse<kDof>(factor, system.H(), variable_b)
               .template block<kDof, kDof>(system.H().row(variable_a), 0);
    }
    covariances.pairs.push_back(RelativeCovariance(T_a_b, covariances.nodes[a], ab, covariances.nodes[b]));
  }
  return covariances;
}

template GraphCovariances<Pose2> MarginalCovariances(
    const PoseGraph2&, const std::vector<std::pair<std::size_t, std::size_t>>&, const std::vector<double>&);
template GraphCovariances<Pose3> MarginalCovariances(
    const PoseGraph3&, const std::vector<std::pair<std::size_t, std::size_t>>&, const std::vector<double>&);

}  // namespace ariadne::slam
