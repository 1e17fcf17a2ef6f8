#include "slam/matching/joint_pair.h"

#include <algorithm>

#include "slam/graph/factors/compressed_factors.h"
#include "slam/registration/gauss_newton.h"
#include "slam/registration/pair_filter.h"

namespace ariadne::slam {
namespace {

/// Two scans of a map as the plane metrics look at them.
PlaneMetric MetricOf(const MapScan& model, const MapScan& data, const AlignOptions& options) {
  return {model.tree_laser.points(), model.surfaces_laser, data.points_laser.positions, data.surfaces_laser,
          options.metric};
}

}  // namespace

JointPair::JointPair(const MapScan& model, const MapScan& data, const AlignOptions& options)
    : model_(model),
      data_(data),
      options_(options),
      tracker_(model.tree_laser, data.points_laser.positions) {}

std::size_t JointPair::CountOverlap(const Pose3& T_model_data) {
  const Correspondences& found = tracker_.Update(T_model_data, options_.max_distance, Parallel(1));
  return CountPairs(found, model_, data_, T_model_data, options_.one_sided);
}

std::size_t JointPair::FindPairs(const Pose3& T_model_data) {
  const Parallel one_thread(1);  // the pairs of scans are what runs in parallel
  const Correspondences& found = tracker_.Update(T_model_data, options_.max_distance, one_thread);
  T_model_data_ = T_model_data;
  pairs_.clear();
  std::vector<double> squared_residuals;
  const PlaneMetric metric = MetricOf(model_, data_, options_);
  const PairFilter filter(model_.surfaces_laser, data_.surfaces_laser, T_model_data, options_);
  const Eigen::Matrix3d R_data_model = T_model_data.RotationMatrix().transpose();
  for (std::size_t i = 0; i < found.model_index.size(); ++i) {
    const std::uint32_t m = found.model_index[i];
    if (m == kNoPoint || !filter.Keeps(i, m)) continue;
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
