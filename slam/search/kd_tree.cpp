#include "slam/search/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kLeafSize = 16;  // measured on the hallway: 8 to 16 are fastest

struct Adaptor {
  const std::vector<Eigen::Vector3d>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3,
                                                 std::uint32_t>;

/// What nanoflann wants of a result set, around the squared radius within which points still matter.
/// nanoflann skips points at exactly that radius, and may offer points that the radius, shrunk since, no
/// longer admits; so the radius is told a rounding step larger, and Add() decides by itself.
class ResultSet {
 public:
  using DistanceType = double;
  bool full() const { return true; }
  double worstDist() const { return limit_; }

 protected:
  void SetLimit(double squared_radius) { limit_ = squared_radius * (1.0 + 1e-15) + 1e-300; }

 private:
  double limit_ = 0.0;
};

class NearestSet : public ResultSet {
 public:
  explicit NearestSet(double max_squared_distance) : max_squared_distance_(max_squared_distance) {
    SetLimit(max_squared_distance);
  }
  bool addPoint(double squared_distance, std::uint32_t index) {
    const Neighbor found{index, squared_distance};
    if (squared_distance < max_squared_distance_ && Nearer(found, best_)) {
      best_ = found;
      SetLimit(squared_distance);
    }
    return true;
  }
  const Neighbor& best() const { return best_; }

 private:
  double max_squared_distance_;
  Neighbor best_;
};

/// The k nearest, kept sorted in the caller's array.
class NearestKSet : public ResultSet {
 public:
  explicit NearestKSet(std::span<Neighbor> nearest) : nearest_(nearest) {
    SetLimit(std::numeric_limits<double>::max());
  }
  bool addPoint(double squared_distance, std::uint32_t index) {
    const Neighbor found{index, squared_distance};
    if (count_ == nearest_.size() && !Nearer(found, nearest_[count_ - 1])) return true;
    std::size_t place = count_ < nearest_.size() ? count_++ : count_ - 1;
    for (; place > 0 && Nearer(found, nearest_[place - 1]); --place) nearest_[place] = nearest_[place - 1];
    nearest_[place] = found;
    if (count_ == nearest_.size()) SetLimit(nearest_[count_ - 1].squared_distance);
    return true;
  }
  std::size_t size() const { return count_; }

 private:
  std::span<Neighbor> nearest_;
  std::size_t count_ = 0;
};

/// The Candidates::kMax nearest within (nearest + margin), and the distance of the first one left out.
class CandidateSet : public ResultSet {
 public:
  CandidateSet(double max_distance, double margin) : max_distance_(max_distance), margin_(margin) {
    UpdateRadius();
  }
  bool addPoint(double squared_distance, std::uint32_t index) {
    const Neighbor found{index, squared_distance};
    if (squared_distance > squared_radius_) return true;
    std::size_t place = std::min(count_, Candidates::kMax);
    if (place == Candidates::kMax && count_ > place && !Nearer(found, nearest_[place])) return true;
    for (; place > 0 && Nearer(found, nearest_[place - 1]); --place) nearest_[place] = nearest_[place - 1];
    nearest_[place] = found;
    count_ = std::min(count_ + 1, Candidates::kMax + 1);
    UpdateRadius();
    return true;
  }

  Candidates Result() const {
    Candidates candidates;
    const std::size_t kept = std::min(count_, Candidates::kMax);
    for (std::size_t i = 0; i < kept; ++i) candidates.index[i] = nearest_[i].index;
    candidates.others_beyond = std::sqrt(squared_radius_);
    return candidates;
  }

 private:
  void UpdateRadius() {
    const double nearest = count_ > 0 ? std::sqrt(nearest_[0].squared_distance) : max_distance_;
    const double radius = std::min(nearest, max_distance_) + margin_;
    squared_radius_ = radius * radius;
    if (count_ > Candidates::kMax) {
      squared_radius_ = std::min(squared_radius_, nearest_[Candidates::kMax].squared_distance);
    }
    SetLimit(squared_radius_);
  }

  double max_distance_;
  double margin_;
  double squared_radius_ = 0.0;
  std::array<Neighbor, Candidates::kMax + 1> nearest_;  // one more: the first that is left out
  std::size_t count_ = 0;
};

}  // namespace

struct KdTree::Index {
  explicit Index(std::vector<Eigen::Vector3d> p)
      : points(std::move(p)), adaptor{points}, tree(3, adaptor, {kLeafSize}) {
    tree.buildIndex();
  }

  template <typename Set>
  void Search(const Eigen::Vector3d& query, Set& set) const {
    // nanoflann sums the distance to a cell up in another order than the distance to a point. This slack
    // (a factor on squared distances) keeps rounding from hiding a point that is as near as the best.
    constexpr float kPruningSlack = -1e-6F;
    tree.findNeighbors(set, query.data(), nanoflann::SearchParams(32, kPruningSlack));
  }

  std::vector<Eigen::Vector3d> points;
  Adaptor adaptor;
  Tree tree;
};

KdTree::KdTree(std::vector<Eigen::Vector3d> points) {
  if (points.size() >= kNoPoint)
    Fail("a k-d tree holds at most {} points, not {}", kNoPoint, points.size());
  index_ = std::make_unique<Index>(std::move(points));
}

KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

const std::vector<Eigen::Vector3d>& KdTree::points() const { return index_->points; }

Neighbor KdTree::Nearest(const Eigen::Vector3d& query, double max_distance) const {
  NearestSet set(max_distance * max_distance);
  index_->Search(query, set);
  return set.best();
}

std::size_t KdTree::NearestK(const Eigen::Vector3d& query, std::span<Neighbor> nearest) const {
  if (nearest.empty()) return 0;
  NearestKSet set(nearest);
  index_->Search(query, set);
  return set.size();
}

Candidates KdTree::NearestWithMargin(const Eigen::Vector3d& query, double max_distance,
                                     double margin) const {
  CandidateSet set(max_distance, margin);
  index_->Search(query, set);
  return set.Result();
}

}  // namespace ariadne::slam
