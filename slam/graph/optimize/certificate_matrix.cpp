#include "slam/graph/optimize/certificate_matrix.h"

#include "slam/graph/linearize.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
constexpr int kD = Pose::Point::RowsAtCompileTime;
template <typename Pose>
using Block = Eigen::Matrix<double, kD<Pose> + 1, kD<Pose> + 1>;
template <typename Pose>
using PoseRow = Eigen::Matrix<double, kD<Pose>, kD<Pose> + 1>;

/// (t, R) of a pose.
template <typename Pose>
PoseRow<Pose> RowOf(const Pose& pose) {
  PoseRow<Pose> row;
  row << pose.translation, pose.RotationMatrix();
  return row;
}

/// The part of M that an edge makes: (t_j - t_i - R_i t_ij, R_j - R_i R_ij) = X_j - X_i A.
template <typename Pose>
struct EdgeBlocks {
  Block<Pose> A;       // [1 0; t_ij R_ij]
  Block<Pose> weight;  // diag(tau, kappa, ...)

  explicit EdgeBlocks(const PoseEdge<Pose>& edge) : A(Block<Pose>::Zero()), weight(Block<Pose>::Zero()) {
    constexpr int d = kD<Pose>;
    A(0, 0) = 1.0;
    A.template bottomLeftCorner<d, 1>() = edge.T_from_to.translation;
    A.template bottomRightCorner<d, d>() = edge.T_from_to.RotationMatrix();
    weight.diagonal().setConstant(0.5 * edge.information(Pose::kDof - 1, Pose::kDof - 1));
    weight(0, 0) = edge.information(0, 0);
  }
};

std::vector<BlockPlace> PlacesOf(const auto& graph) {
  std::vector<BlockPlace> places;
  for (const auto& edge : graph.edges) places.emplace_back(edge.from, edge.to);
  return places;
}

}  // namespace

template <typename Pose>
CertificateMatrix MakeCertificateMatrix(const PoseGraph<Pose>& graph) {
  constexpr int d = kD<Pose>;
  const std::vector<BlockPlace> places = PlacesOf(graph);
  CertificateMatrix certificate{BlockMatrix(d + 1, OrderBlocks(graph.nodes.size(), places), places)};
  std::vector<PoseRow<Pose>> X;
  for (const PoseNode<Pose>& node : graph.nodes) X.push_back(RowOf(node.T_map_node));
  std::vector<PoseRow<Pose>> XM(graph.nodes.size(), PoseRow<Pose>::Zero());
  for (const PoseEdge<Pose>& edge : graph.edges) {
    const EdgeBlocks<Pose> blocks(edge);
    const Block<Pose> weighted = blocks.A * blocks.weight;
    certificate.S.template Add<d + 1>(certificate.S.Diagonal(edge.to), blocks.weight);
    certificate.S.template Add<d + 1>(certificate.S.Diagonal(edge.from), weighted * blocks.A.transpose());
    certificate.S.template Add<d + 1>(certificate.S.Find(edge.from, edge.to), -weighted);
    const PoseRow<Pose> residual = (X[edge.to] - X[edge.from] * blocks.A) * blocks.weight;
    XM[edge.to] += residual;
    XM[edge.from] -= residual * blocks.A.transpose();
  }
  certificate.scale = certificate.S.DiagonalEntries().maxCoeff();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Eigen::Matrix<double, d, d> product =
        X[i].template rightCols<d>().transpose() * XM[i].template rightCols<d>();
    Block<Pose> multipliers = Block<Pose>::Zero();
    multipliers.template bottomRightCorner<d, d>() = 0.5 * (product + product.transpose());
    certificate.trace_of_multipliers += product.trace();
    certificate.S.template Add<d + 1>(certificate.S.Diagonal(i), -multipliers);
  }
  Block<Pose> gauge = Block<Pose>::Zero();
  gauge(0, 0) = certificate.S.DiagonalEntries()[certificate.S.row(0)];
  certificate.S.template Add<d + 1>(certificate.S.Diagonal(0), gauge);
  return certificate;
}

template CertificateMatrix MakeCertificateMatrix(const PoseGraph2&);
template CertificateMatrix MakeCertificateMatrix(const PoseGraph3&);

}  // namespace ariadne::slam
