#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace ariadne::slam {

inline constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// A point of the tree, and how far it is from the query.
struct Neighbor {
  std::uint32_t index = kNoPoint;
  double squared_distance = std::numeric_limits<double>::infinity();  // [m^2]
};

/// The squared distance, summed in one fixed order: all searches round it alike.
inline double SquaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d d = a - b;
  return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
}

/// Of two equally near points the one with the lower index is the nearer: every search then has one answer.
inline bool Nearer(const Neighbor& a, const Neighbor& b) {
  return a.squared_distance < b.squared_distance ||
         (a.squared_distance == b.squared_distance && a.index < b.index);
}

/// The few points nearest to a query, and a radius that no other point is within. While the query moves by
/// less than the slack that the radius leaves, its nearest point is among the few (slam/registration).
struct Candidates {
  static constexpr std::size_t kMax = 4;
  std::array<std::uint32_t, kMax> index{kNoPoint, kNoPoint, kNoPoint, kNoPoint};  // nearest first
  double others_beyond = 0.0;  // all other points are at least this far from the query [m]
};

/// A k-d tree over points in space (nanoflann). All searches are exact.
class KdTree {
 public:
  /// Keeps its own copy of the points; they must be finite.
  explicit KdTree(std::vector<Eigen::Vector3d> points);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  const std::vector<Eigen::Vector3d>& points() const;

  /// The nearest point closer than max_distance [m]; index kNoPoint where there is none.
  Neighbor Nearest(const Eigen::Vector3d& query, double max_distance) const;

  /// Fills `nearest` with the nearest points, nearest first; returns how many there are.
  std::size_t NearestK(const Eigen::Vector3d& query, std::span<Neighbor> nearest) const;

  /// The candidates within the distance of the nearest point (at most max_distance) plus margin [m].
  Candidates NearestWithMargin(const Eigen::Vector3d& query, double max_distance, double margin) const;

 private:
  struct Index;  // keeps nanoflann out of the headers
  std::unique_ptr<Index> index_;
};

}  // namespace ariadne::slam
