#include "slam/matching/joint_pair.h"

#include <algorithm>

#include "slam/graph/factors/compressed_factors.h"
#include "slam/registration/gauss_newton.h"

namespace ariadne::slam {
namespace {

const std::vector<SurfacePoint> kNoSurfaces;

/// Two scans of a map as the plane metrics look at them.
PlaneMetric MetricOf(const MapScan& model, const MapScan& data, const AlignOptions& options) {
  const bool planes = options.metric == Metric::kPlaneToPlane;
  return {model.tree_laser.points(), model.surfaces_laser, data.points_laser.positions,
          planes ? data.surfaces_laser : kNoSurfaces};
}

/// Whether a pair counts at all: the metric has its normals, and the model does not end there.
bool IsUsable(const MapScan& model, const MapScan& data, std::size_t i, std::uint32_t m,
              const AlignOptions& options) {
  if (m == kNoPoint) return false;
  if (options.skip_boundary && model.surfaces_laser[m].boundary) return false;
  if (options.metric == Metric::kPointToPoint) return true;
  if (!model.surfaces_laser[m].has_normal()) return false;
  return options.metric == Metric::kPointToPlane || data.surfaces_laser[i].has_normal();
}

}  // namespace

JointPair::JointPair(const MapScan& model, const MapScan& data, const AlignOptions& options)
    : model_(model),
      data_(data),
      options_(options),
      tracker_(model.tree_laser, data.points_laser.positions) {}

std::size_t JointPair::CountOverlap(const Pose3& T_model_data) {
  const Correspondences& found = tracker_.Update(T_model_data, options_.max_distance, Parallel(1));
  const auto unpaired = std::ranges::count(found.model_index, kNoPoint);
  return found.model_index.size() - static_cast<std::size_t>(unpaired);
}

std::size_t JointPair::FindPairs(const Pose3& T_model_data) {
  const Parallel one_thread(1);  // the pairs of scans are what runs in parallel
  const Correspondences& found = tracker_.Update(T_model_data, options_.max_distance, one_thread);
  T_model_data_ = T_model_data;
  pairs_.clear();
  std::vector<double> squared_residuals;
  const PlaneMetric metric = MetricOf(model_, data_, options_);
  const Eigen::Matrix3d R_data_model = T_model_data.RotationMatrix().transpose();
  for (std::size_t i = 0; i < found.model_index.size(); ++i) {
    const std::uint32_t m = found.model_index[i];
    if (!IsUsable(model_, data_, i, m, options_)) continue;
    pairs_.push_back({static_cast<std::uint32_t>(i), m, 0.0});
    squared_residuals.push_back(options_.metric == Metric::kPointToPoint
                                    ? found.squared_distance[i]
                                    : metric.Error(i, m, T_model_data, R_data_model).Squared());
  }
  Weigh(squared_residuals);
  return pairs_.size();
}

void JointPair::Weigh(const std::vector<double>& squared_residuals) {
  const PairWeight weight =
      ChooseWeight(squared_residuals, options_.trim, options_.kernel, options_.kernel_scale);
  sum_squared_ = weight_ = 0.0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    pairs_[k].weight = weight(squared_residuals[k]);
    sum_squared_ += pairs_[k].weight * squared_residuals[k];
    weight_ += pairs_[k].weight;
  }
}

std::unique_ptr<ceres::CostFunction> JointPair::MakeFactor() const {
  const std::vector<Eigen::Vector3d>& model_points = model_.tree_laser.points();
  const std::vector<Eigen::Vector3d>& data_points = data_.points_laser.positions;
  if (options_.metric == Metric::kPointToPoint) {
    PointPairMoments moments(T_model_data_);
    for (const WeightedPair& pair : pairs_)
      moments.Add(data_points[pair.data], model_points[pair.model], pair.weight);
    return MakePointFactor(moments);
  }
  const PlaneMetric metric = MetricOf(model_, data_, options_);
  const Eigen::Matrix3d R_model_data = T_model_data_.RotationMatrix();
  const Eigen::Matrix3d R_data_model = R_model_data.transpose();
  PlanePairMoments moments(T_model_data_);
  for (const WeightedPair& pair : pairs_) {
    if (pair.weight == 0.0) continue;
    const PairError error = metric.Error(pair.data, pair.model, T_model_data_, R_data_model);
    const Eigen::Matrix3d information_data = pair.weight * error.Information();
    moments.Add(data_points[pair.data], model_points[pair.model],
                R_model_data * information_data * R_data_model);
  }
  return MakePlaneFactor(moments);
}

}  // namespace ariadne::slam
