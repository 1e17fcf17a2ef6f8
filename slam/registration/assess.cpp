#include "slam/registration/assess.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "slam/geometry/so3.h"
#include "slam/registration/gauss_newton.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kPairs = 2000;           // on which a large cloud is assessed
constexpr std::size_t kRadiusSamples = 100;    // that tell how large neighbourhoods are
constexpr double kCellPerNeighborhood = 2.0;   // edge of a cell over the radius of a neighbourhood
using Jacobian = Eigen::Matrix<double, 3, 6>;  // of a data point by the tangent
using UpTo6 = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;  // not on the heap

/// What one cell has to say about the pose.
struct CellSum {
  Pose3::Square H = Pose3::Square::Zero();
  Pose3::Tangent gradient = Pose3::Tangent::Zero();
};

/// The sums over the pairs of all cells that were looked at.
struct Sandwich {
  std::vector<CellSum> cells;
  Pose3::Square H = Pose3::Square::Zero();
  Pose3::Square motions = Pose3::Square::Zero();  // of Observability
  std::size_t pairs = 0;
  std::size_t with_normal = 0;
};

/// The pairs' data indices by cell, in an order that looks random.
using Cells = std::vector<std::vector<std::size_t>>;

double NeighborhoodRadius(const Converged& c, const std::vector<std::size_t>& paired, int neighbors) {
  std::vector<double> radii;
  const std::size_t stride = std::max<std::size_t>(1, paired.size() / kRadiusSamples);
  for (std::size_t k = 0; k < paired.size(); k += stride) {
    const std::uint32_t m = c.pairs.model_index[paired[k]];
    radii.push_back(EstimateSurface(c.model.tree, m, neighbors).radius);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

Cells GroupByCell(const Converged& c, const std::vector<std::size_t>& paired, double edge) {
  std::map<std::uint64_t, std::vector<std::size_t>> cells;
  for (const std::size_t i : paired) {
    std::uint64_t key = 0x9E3779B97F4A7C15ULL;
    for (int axis = 0; axis < 3; ++axis) {
      const auto cell = static_cast<std::int64_t>(std::floor(c.data.points[i][axis] / edge));
      key = (key ^ static_cast<std::uint64_t>(cell)) * 0xBF58476D1CE4E5B9ULL;
      key ^= key >> 29;
    }
    cells[key].push_back(i);
  }
  Cells grouped;
  for (auto& [key, members] : cells) grouped.push_back(std::move(members));
  return grouped;
}

/// Adds one pair to its cell, and the motion that it holds to the sum.
void AddPair(const Converged& c, const AlignOptions& options, std::size_t i, CellSum& cell, Sandwich& sum) {
  const std::uint32_t m = c.pairs.model_index[i];
  const Eigen::Matrix3d R_data_model = c.T_model_data.RotationMatrix().transpose();
  const SurfacePoint surface = c.model.surfaces.empty()
                                   ? EstimateSurface(c.model.tree, m, options.normal_neighbors)
                                   : c.model.surfaces[m];
  const Eigen::Vector3d normal = R_data_model * surface.normal;  // zero where there is none
  const Eigen::Vector3d d_center = c.data.points[i] - c.center_data;
  Jacobian J;
  J << Eigen::Matrix3d::Identity(), -Hat(d_center);
  ++sum.pairs;
  if (surface.has_normal()) {
    Pose3::Tangent motion;
    motion << normal, d_center.cross(normal) / c.length;
    sum.motions += motion * motion.transpose();
    ++sum.with_normal;
  }
  if (options.metric == Metric::kPointToPoint) {
    const Eigen::Vector3d e =
        c.data.points[i] + R_data_model * (c.T_model_data.translation - c.model.tree.points()[m]);
    const double w = c.weight(e.squaredNorm());
    const Pose3::Tangent along_normal = J.transpose() * normal;
    const double curvature = w + 2.0 * c.weight.Derivative(e.squaredNorm()) * std::pow(normal.dot(e), 2);
    cell.H += curvature * along_normal * along_normal.transpose();
    cell.gradient += w * J.transpose() * e;
    return;
  }
  const PlaneMetric metric{c.model.tree.points(), c.model.surfaces, c.data.points, c.data.surfaces,
                           options.metric};
  const PairError error = metric.Error(i, m, c.T_model_data, R_data_model);
  const Eigen::Matrix3d information = error.Information();
  const double w = c.weight(error.Squared());
  const double curvature = w + 2.0 * c.weight.Derivative(error.Squared()) * error.Squared();
  cell.H += curvature * J.transpose() * information * J;
  cell.gradient += w * J.transpose() * information * error.e;
}

/// The covariance about the center from the cells, which are a share of all. Directions that are not
/// observed get the variance of the gate: the data may have slid by anything that has kept the pairs.
Pose3::Square Covariance(const Sandwich& sum, double share, const Observability& observability,
                         double length, double max_distance) {
  Pose3::Tangent scale;
  scale << 1.0, 1.0, 1.0, 1.0 / length, 1.0 / length, 1.0 / length;
  const int free = observability.degenerate;
  const UpTo6 held = scale.asDiagonal() * observability.directions.rightCols(Pose3::kDof - free);
  const UpTo6 slack = scale.asDiagonal() * observability.directions.leftCols(free);
  const UpTo6 H = held.transpose() * sum.H * held / share;
  UpTo6 scatter = UpTo6::Zero(H.rows(), H.cols());
  for (const CellSum& cell : sum.cells) {
    const UpTo6 H_without = H - held.transpose() * cell.H * held;
    const UpTo6 moved = H_without.partialPivLu().solve(held.transpose() * cell.gradient);
    scatter += moved * moved.transpose();
  }
  return held * scatter * held.transpose() / share +
         max_distance * max_distance * slack * slack.transpose();
}

}  // namespace

Assessment AssessPairs(const Converged& converged, const AlignOptions& options) {
  std::vector<std::size_t> paired;
  for (std::size_t i = 0; i < converged.data.points.size(); ++i) {
    if (converged.pairs.model_index[i] != kNoPoint) paired.push_back(i);
  }
  const double edge =
      kCellPerNeighborhood * NeighborhoodRadius(converged, paired, options.normal_neighbors);
  Sandwich sum;
  for (const std::vector<std::size_t>& cell : GroupByCell(converged, paired, std::max(edge, 1e-9))) {
    CellSum& cell_sum = sum.cells.emplace_back();
    for (const std::size_t i : cell) AddPair(converged, options, i, cell_sum, sum);
    sum.H += cell_sum.H;
    if (sum.pairs >= kPairs) break;
  }
  Assessment assessment;
  assessment.observability = ObserveMotions(sum.motions, sum.with_normal, options.min_observability);
  const double share = static_cast<double>(sum.pairs) / static_cast<double>(paired.size());
  const Pose3::Square about_center =
      Covariance(sum, share, assessment.observability, converged.length, options.max_distance);
  const Pose3::Square shift = Pose3{Eigen::Quaterniond::Identity(), converged.center_data}.Adjoint();
  assessment.covariance = shift * about_center * shift.transpose();
  return assessment;
}

}  // namespace ariadne::slam
