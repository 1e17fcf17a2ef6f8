#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "slam/base/parallel.h"
#include "slam/geometry/pose3.h"
#include "slam/registration/correspondences.h"
#include "slam/search/kd_tree.h"

namespace ariadne::slam {

/// Finds the correspondences of the same two clouds at a sequence of poses, and searches the tree only for
/// the points whose last neighbours may have become wrong. The result is identical to FindByKdTree.
///
/// A search keeps the few nearest model points and a radius L that no other point is within. When the
/// data point has moved by s since, every other model point is still at least L - s away; so if the nearest
/// of the few is closer than that, or L - s is beyond the gate, the answer is proven without a search.
///
/// Most points need not even look at the few: chunks of data points carry an odometer, which sums up bounds
/// of how far any of their points has moved from pose to pose; and a point knows the reading up to which
/// its nearest neighbour cannot have changed.
class CorrespondenceTracker {
 public:
  /// Refers to both clouds; they must outlive the tracker.
  CorrespondenceTracker(const KdTree& model, const std::vector<Eigen::Vector3d>& data);

  /// max_distance [m] may change from call to call.
  const Correspondences& Update(const Pose3& T_model_data, double max_distance, const Parallel& parallel);

  /// How many searches all calls together have made.
  std::size_t searches() const { return searches_; }

 private:
  struct Chunk {
    Eigen::Vector3d center_data;  // of a sphere around the chunk's points
    double radius = 0.0;          // [m]
    double odometer = 0.0;        // no point of the chunk has moved farther than this since the start [m]
  };
  struct Memory {
    Eigen::Vector3d searched_at;  // where the point was when its candidates were found (model frame)
    Candidates candidates;
  };

  std::vector<Chunk> MakeChunks() const;
  void Forget();
  void Drive(const Pose3& T_model_data);
  bool Prove(std::size_t i, const Eigen::Vector3d& p_model, double odometer);
  void Search(std::size_t i, const Eigen::Vector3d& p_model, double odometer);
  void Store(std::size_t i, const Eigen::Vector3d& p_model);

  const KdTree& model_;
  const std::vector<Eigen::Vector3d>& model_points_;
  const std::vector<Eigen::Vector3d>& data_;
  std::vector<Chunk> chunks_;
  std::vector<double> safe_until_;      // odometer reading, one per data point [m]
  std::vector<std::uint32_t> nearest_;  // whatever its distance, one per data point; kNoPoint: none near
  std::vector<Memory> memory_;
  Correspondences pairs_;
  std::optional<Pose3> T_model_data_;  // of the last update
  double max_distance_ = 0.0;          // of the last update [m]
  double extent_ = 0.0;                // largest coordinate of either cloud [m]
  double rounding_ = 0.0;              // bound on the rounding error of a distance at this pose [m]
  std::size_t searches_ = 0;
};

}  // namespace ariadne::slam
