#include "slam/matching/scan_graph.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr double kOdometryPosition = 0.05;  // sigma of the odometry between stops at one place [m]
constexpr double kOdometryAngle = 0.05;     // [rad]

/// The odometry's own errors, those of wheels on a floor, are less; but a floor is not known to be even,
/// unless the options say so.
Pose3::Square OdometryInformation(const Pose3& T_from_to, const ScanGraphOptions& options) {
  const double way = T_from_to.translation.norm();
  const double position = std::hypot(kOdometryPosition, options.odometry_position * way);
  const double angle = std::hypot(kOdometryAngle, options.odometry_angle * way);
  const double height = std::min(position, options.floor_height);
  const double tilt = std::min(angle, options.floor_tilt);
  Pose3::Tangent sigma;
  sigma << position, position, height, tilt, tilt, angle;
  return sigma.cwiseAbs2().cwiseInverse().asDiagonal();
}

/// Motions of the data, in columns, that the surfaces do not notice; in the tangent space of its pose.
Eigen::Matrix<double, 6, Eigen::Dynamic> FreeMotions(const Observability& observability,
                                                     const PointCloud& data) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : data.positions) center += p;
  center /= static_cast<double>(data.size());
  double squared_length = 0.0;
  for (const Eigen::Vector3d& p : data.positions) squared_length += (p - center).squaredNorm();
  const double length = std::sqrt(squared_length / static_cast<double>(data.size()));
  Pose3::Tangent scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / length);
  const Pose3::Square shift = Pose3{Eigen::Quaterniond::Identity(), center}.Adjoint();
  return shift * scale.asDiagonal() * observability.directions.leftCols(observability.degenerate);
}

}  // namespace

Pose3::Square InformationOf(const AlignResult& align, const PointCloud& data,
                            const ScanGraphOptions& options) {
  if (!align.assessment) Fail("an alignment without assessment has no information (icp.assess is off)");
  Pose3::Tangent systematic;
  systematic << Eigen::Vector3d::Constant(options.systematic_position * options.systematic_position),
      Eigen::Vector3d::Constant(options.systematic_angle * options.systematic_angle);
  const Pose3::Square covariance = align.assessment->covariance + Pose3::Square(systematic.asDiagonal());
  const int free = align.assessment->observability.degenerate;
  if (free == 0) return covariance.llt().solve(Pose3::Square::Identity());
  if (free == Pose3::kDof) return Pose3::Square::Zero();
  // An orthonormal basis of all that gives the free motions no length.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(FreeMotions(align.assessment->observability, data));
  const Eigen::MatrixXd Q = qr.householderQ();
  const Eigen::MatrixXd held = Q.rightCols(Pose3::kDof - free);
  const Eigen::MatrixXd inverse = (held.transpose() * covariance * held).inverse();
  const Pose3::Square information = held * inverse * held.transpose();
  return 0.5 * (information + information.transpose());
}

void AddMissingNodes(ScanMap& map, const ScanGraphOptions& options) {
  PoseGraph3& graph = map.graph.graph;
  for (std::size_t i = graph.nodes.size(); i < map.scans.size(); ++i) {
    graph.nodes.push_back({static_cast<std::int64_t>(i), map.scans[i].T_map_laser, i == 0});
    if (i == 0) continue;
    const Pose3 T_from_to = map.scans[i - 1].T_map_laser.Inverse() * map.scans[i].T_map_laser;
    const auto& covariance = map.scans[i].guess_covariance;
    const Pose3::Square information =
        covariance ? Pose3::Square(covariance->inverse()) : OdometryInformation(T_from_to, options);
    graph.edges.push_back({i - 1, i, T_from_to, information});
    map.graph.kinds.push_back(ScanEdgeKind::kOdometry);
  }
}

void AddAlignment(ScanMap& map, std::size_t from, std::size_t to, const AlignResult& align,
                  const ScanGraphOptions& options, ScanEdgeKind kind) {
  const Pose3 T_from_to = map.scans[from].T_map_laser.Inverse() * align.T_model_data;
  map.graph.graph.edges.push_back(
      {from, to, T_from_to, InformationOf(align, map.scans[to].points_laser, options)});
  map.graph.kinds.push_back(kind);
}

bool AreJoined(const ScanGraph& graph, std::size_t a, std::size_t b) {
  for (std::size_t k = 0; k < graph.kinds.size(); ++k) {
    const PoseEdge<Pose3>& edge = graph.graph.edges[k];
    if (graph.kinds[k] == ScanEdgeKind::kOdometry) continue;
    if ((edge.from == a && edge.to == b) || (edge.from == b && edge.to == a)) return true;
  }
  return false;
}

}  // namespace ariadne::slam
