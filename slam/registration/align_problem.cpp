#include "slam/registration/align_problem.h"

#include <cmath>

#include "slam/registration/assess.h"
#include "slam/registration/gauss_newton.h"
#include "slam/registration/pair_filter.h"
#include "slam/registration/rigid_fit.h"

namespace ariadne::slam {
namespace {

Eigen::Vector3d Centroid(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) offset += p - points.front();
  return points.front() + offset / static_cast<double>(points.size());
}

/// Root mean square distance from the center; 1 m for a cloud without extent.
double CharacteristicLength(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& center) {
  double sum = 0.0;
  for (const Eigen::Vector3d& p : points) sum += (p - center).squaredNorm();
  return sum > 0.0 ? std::sqrt(sum / static_cast<double>(points.size())) : 1.0;
}

std::vector<double> SquaredDistances(const Correspondences& pairs) {
  std::vector<double> squared;
  squared.reserve(pairs.model_index.size());
  for (std::size_t i = 0; i < pairs.model_index.size(); ++i) {
    if (pairs.model_index[i] != kNoPoint) squared.push_back(pairs.squared_distance[i]);
  }
  return squared;
}

}  // namespace

AlignProblem::AlignProblem(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
                           const AlignOptions& options)
    : model_(model),
      data_(data),
      options_(options),
      parallel_(options.threads),
      tracker_(model.tree, data.points),
      center_model_(Centroid(model.tree.points())),
      center_data_(Centroid(data.points)),
      length_(CharacteristicLength(data.points, center_data_)),
      guess_(PairsOfGuess(T_model_data_guess, length_)) {}

Improvement AlignProblem::Improve(const Pose3& T_model_data, double max_distance) {
  FindPairs(T_model_data, max_distance);
  ChooseWeights(T_model_data, max_distance == options_.max_distance);
  return options_.metric == Metric::kPointToPoint ? FitPoints() : StepToPlanes(T_model_data);
}

void AlignProblem::FindPairs(const Pose3& T_model_data, double max_distance) {
  if (options_.search == Search::kBruteForce) {
    own_pairs_ =
        FindByBruteForce(model_.tree.points(), data_.points, T_model_data, max_distance, parallel_);
    pairs_ = &own_pairs_;
  } else {
    pairs_ = &tracker_.Update(T_model_data, max_distance, parallel_);
  }
  if (NeedsModelSurfaces(options_)) DropUnusablePairs(T_model_data);
}

void AlignProblem::DropUnusablePairs(const Pose3& T_model_data) {
  if (pairs_ != &own_pairs_) own_pairs_ = *pairs_;
  pairs_ = &own_pairs_;
  const PairFilter filter(model_.surfaces, data_.surfaces, T_model_data, options_);
  for (std::size_t i = 0; i < own_pairs_.model_index.size(); ++i) {
    std::uint32_t& m = own_pairs_.model_index[i];
    if (m != kNoPoint && !filter.Keeps(i, m)) m = kNoPoint;
  }
}

void AlignProblem::ChooseWeights(const Pose3& T_model_data, bool with_kernel) {
  const RobustKernel kernel = with_kernel ? options_.kernel : RobustKernel::kNone;
  std::vector<double> squared_residuals;
  if (options_.trim < 1.0 || (kernel != RobustKernel::kNone && options_.kernel_scale == 0.0)) {
    const PlaneMetric metric{model_.tree.points(), model_.surfaces, data_.points, data_.surfaces,
                             options_.metric};
    squared_residuals = options_.metric == Metric::kPointToPoint
                            ? SquaredDistances(*pairs_)
                            : SquaredResiduals(metric, *pairs_, T_model_data);
  }
  weight_ = ChooseWeight(std::move(squared_residuals), options_.trim, kernel, options_.kernel_scale);
}

PairMoments AlignProblem::HoldToGuess(PairMoments moments) const {
  const double weight = options_.guess_share * moments.weight() / static_cast<double>(guess_.data.size());
  for (std::size_t k = 0; weight > 0.0 && k < guess_.data.size(); ++k)
    moments.Add(guess_.model[k] - center_model_, guess_.data[k] - center_data_, weight, 0.0);
  return moments;
}

void AlignProblem::HoldToGuess(const Pose3& T_model_data, NormalEquations& equations) const {
  const double weight = options_.guess_share * equations.weight / static_cast<double>(guess_.data.size());
  const Pose3 T_data_model = T_model_data.Inverse();
  for (std::size_t k = 0; weight > 0.0 && k < guess_.data.size(); ++k)
    AddPointTerm(equations, guess_.data[k] - center_data_, guess_.data[k] - T_data_model * guess_.model[k],
                 weight);
}

Improvement AlignProblem::FitPoints() const {
  const std::vector<Eigen::Vector3d>& model_points = model_.tree.points();
  const PairMoments moments = parallel_.Reduce(
      data_.points.size(), kPairsPerChunk, PairMoments{}, [&](std::size_t begin, std::size_t end) {
        PairMoments sum;
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t m = pairs_->model_index[i];
          if (m == kNoPoint) continue;
          const double w = weight_(pairs_->squared_distance[i]);
          if (w == 0.0) continue;
          sum.Add(model_points[m] - center_model_, data_.points[i] - center_data_, w,
                  pairs_->squared_distance[i]);
        }
        return sum;
      });
  if (moments.pairs == 0) return {};
  const PairMoments held = HoldToGuess(moments);
  const RigidFit fit =
      options_.closed_form == ClosedForm::kQuaternion ? FitByQuaternion(held) : FitBySvd(held);
  const Pose3& centered = fit.T_model_data;  // between coordinates relative to the two centers
  const Pose3 T_model_data{centered.rotation,
                           centered.translation + center_model_ - centered.rotation * center_data_};
  return {T_model_data, moments.pairs, std::sqrt(moments.sum_squared_distance / moments.weight()),
          fit.unique};
}

Improvement AlignProblem::StepToPlanes(const Pose3& T_model_data) const {
  const PlaneMetric metric{model_.tree.points(), model_.surfaces, data_.points, data_.surfaces,
                           options_.metric};
  NormalEquations equations =
      GatherNormalEquations(metric, *pairs_, T_model_data, center_data_, weight_, parallel_);
  if (equations.pairs == 0) return {};
  HoldToGuess(T_model_data, equations);
  const Pose3::Tangent step = SolveStep(equations, length_);
  return {T_model_data * ExpAbout(center_data_, step), equations.pairs,
          std::sqrt(equations.sum_squared / equations.weight), true};
}

Assessment AlignProblem::Assess(const Pose3& T_model_data) const {
  return AssessPairs({model_, data_, *pairs_, T_model_data, weight_, center_data_, length_}, options_);
}

}  // namespace ariadne::slam
