#include "slam/registration/pair_filter.h"

namespace ariadne::slam {

bool AreOpposite(const SurfacePoint& model, const SurfacePoint& data, const Eigen::Matrix3d& R_model_data) {
  return model.normal.dot(R_model_data * data.normal) < 0.0;
}

PairFilter::PairFilter(const std::vector<SurfacePoint>& model, const std::vector<SurfacePoint>& data,
                       const Pose3& T_model_data, const AlignOptions& options)
    : model_(model), data_(data), R_model_data_(T_model_data.RotationMatrix()), options_(options) {}

bool PairFilter::Keeps(std::size_t data_index, std::uint32_t model_index) const {
  if (options_.skip_boundary && model_[model_index].boundary) return false;
  if (options_.one_sided && AreOpposite(model_[model_index], data_[data_index], R_model_data_))
    return false;
  if (options_.metric == Metric::kPointToPoint) return true;
  if (!model_[model_index].has_normal()) return false;
  return options_.metric == Metric::kPointToPlane || data_[data_index].has_normal();
}

}  // namespace ariadne::slam
