#include "slam/registration/correspondence_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "slam/geometry/box3.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kPointsPerChunk = 256;  // points that share an odometer

// Motion shrinks by a roughly constant factor per iteration; a margin of twice the last motion makes one
// search serve most of what is left (measured on the hallway: 2 is best, 1 to 5 are close).
constexpr double kMarginPerMotion = 2.0;
constexpr double kFirstMargin = 0.1;         // of the gate, before any motion is known
constexpr double kRelativeTolerance = 1e-9;  // the square of a square root may be a rounding step too small
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Sum {
  std::size_t value = 0;
  Sum& operator+=(const Sum& other) { return value += other.value, *this; }
};

}  // namespace

CorrespondenceTracker::CorrespondenceTracker(const KdTree& model, const std::vector<Eigen::Vector3d>& data)
    : model_(model), model_points_(model.points()), data_(data), chunks_(MakeChunks()) {
  for (const auto* points : {&model_points_, &data_}) {
    for (const Eigen::Vector3d& p : *points) extent_ = std::max(extent_, p.cwiseAbs().maxCoeff());
  }
  pairs_.model_index.resize(data.size());
  pairs_.squared_distance.resize(data.size());
  Forget();
}

std::vector<CorrespondenceTracker::Chunk> CorrespondenceTracker::MakeChunks() const {
  std::vector<Chunk> chunks;
  for (std::size_t begin = 0; begin < data_.size(); begin += kPointsPerChunk) {
    const std::size_t end = std::min(begin + kPointsPerChunk, data_.size());
    const Box3 box = BoxAround({data_.begin() + static_cast<std::ptrdiff_t>(begin),
                                data_.begin() + static_cast<std::ptrdiff_t>(end)});
    chunks.push_back({box.center(), 0.5 * box.diagonal().norm(), 0.0});
  }
  return chunks;
}

void CorrespondenceTracker::Forget() {
  Memory nothing{Eigen::Vector3d::Zero(), {}};
  nothing.candidates.others_beyond = -kInfinity;
  memory_.assign(data_.size(), nothing);
  nearest_.assign(data_.size(), kNoPoint);
  safe_until_.assign(data_.size(), -kInfinity);
}

const Correspondences& CorrespondenceTracker::Update(const Pose3& T_model_data, double max_distance,
                                                     const Parallel& parallel) {
  if (max_distance > max_distance_) Forget();  // what was beyond the gate may be within it now
  max_distance_ = max_distance;
  rounding_ = 1e-14 * (extent_ + T_model_data.translation.cwiseAbs().maxCoeff() + max_distance);
  Drive(T_model_data);
  const Eigen::Matrix3d R = T_model_data.RotationMatrix();
  const Sum searched =
      parallel.Reduce(data_.size(), kPointsPerChunk, Sum{}, [&](std::size_t begin, std::size_t end) {
        const double odometer = chunks_[begin / kPointsPerChunk].odometer;
        Sum searches;
        for (std::size_t i = begin; i < end; ++i) {
          const Eigen::Vector3d p_model = R * data_[i] + T_model_data.translation;
          if (odometer > safe_until_[i] && !Prove(i, p_model, odometer)) {
            Search(i, p_model, odometer);
            ++searches.value;
          }
          Store(i, p_model);
        }
        return searches;
      });
  searches_ += searched.value;
  return pairs_;
}

void CorrespondenceTracker::Drive(const Pose3& T_model_data) {
  if (T_model_data_) {
    const double angle = RotationDistance(*T_model_data_, T_model_data);
    for (Chunk& chunk : chunks_) {
      const Eigen::Vector3d moved = T_model_data * chunk.center_data - *T_model_data_ * chunk.center_data;
      chunk.odometer += moved.norm() + angle * chunk.radius + rounding_;
    }
  }
  T_model_data_ = T_model_data;
}

bool CorrespondenceTracker::Prove(std::size_t i, const Eigen::Vector3d& p_model, double odometer) {
  const auto& [searched_at, candidates] = memory_[i];
  Neighbor first, second;
  for (const std::uint32_t index : candidates.index) {
    if (index == kNoPoint) break;
    const Neighbor candidate{index, SquaredDistance(model_points_[index], p_model)};
    if (Nearer(candidate, first)) {
      second = std::exchange(first, candidate);
    } else if (Nearer(candidate, second)) {
      second = candidate;
    }
  }
  const double others_beyond = candidates.others_beyond - (p_model - searched_at).norm() - rounding_;
  const double distance = std::min(std::sqrt(first.squared_distance), max_distance_);
  if (distance >= others_beyond) return false;
  const bool paired = std::sqrt(first.squared_distance) < max_distance_;
  nearest_[i] = paired ? first.index : kNoPoint;
  // Both the nearest and its rival may move by the slack: it is half of the difference.
  const double rival = paired ? std::sqrt(second.squared_distance) : std::sqrt(first.squared_distance);
  safe_until_[i] = odometer + 0.5 * (std::min(rival, others_beyond) - distance) - rounding_;
  return true;
}

void CorrespondenceTracker::Search(std::size_t i, const Eigen::Vector3d& p_model, double odometer) {
  auto& [searched_at, candidates] = memory_[i];
  double bound = max_distance_;
  for (const std::uint32_t index : candidates.index) {
    if (index == kNoPoint) break;
    bound = std::min(bound, (model_points_[index] - p_model).norm());
  }
  const bool initial = std::isinf(candidates.others_beyond);
  const double margin =
      initial ? kFirstMargin * max_distance_ : kMarginPerMotion * (p_model - searched_at).norm();
  candidates =
      model_.NearestWithMargin(p_model, bound, margin + kRelativeTolerance * max_distance_ + rounding_);
  searched_at = p_model;
  if (Prove(i, p_model, odometer)) return;
  // More points than candidates are equally near: the order of their indices has decided.
  nearest_[i] = candidates.index[0];
  safe_until_[i] = -kInfinity;
}

void CorrespondenceTracker::Store(std::size_t i, const Eigen::Vector3d& p_model) {
  Neighbor pair{nearest_[i], 0.0};
  if (pair.index != kNoPoint) pair.squared_distance = SquaredDistance(model_points_[pair.index], p_model);
  const bool within = pair.squared_distance < max_distance_ * max_distance_;
  pairs_.model_index[i] = within ? pair.index : kNoPoint;
  pairs_.squared_distance[i] = pair.squared_distance;
}

}  // namespace ariadne::slam
