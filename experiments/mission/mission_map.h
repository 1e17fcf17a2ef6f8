#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/mission/ground_map.h"
#include "experiments/mission/mission_options.h"

namespace ariadne::experiments {

/// What a mission knows after some scans: where they lie, what is free at each height, and what stands in
/// the way. Scans that could not be registered lie where odometry says and show nothing.
class MissionMap {
 public:
  MissionMap(const MissionOptions& options, const slam::Pose3& T_base_laser);

  /// Registers a scan from a first guess; that of the first scan defines the map's frame. The covariance is
  /// that of the guess, in its tangent space, if it is known.
  slam::MatchResult AddScan(const std::string& name, slam::PointCloud cloud_laser,
                            const slam::Pose2& T_map_base_guess,
                            const std::optional<slam::Pose2::Square>& covariance);

  /// Makes all poses agree once more, after the last scan.
  slam::MatchResult Finish();

  /// Something stands there that the robot cannot pass, whatever the scans show.
  void AddObstacle(const Eigen::Vector2d& p_map) { ground_.AddObstacle(p_map); }

  std::size_t size() const { return mapper_.scans().size(); }
  bool registered(std::size_t scan) const { return mapper_.scans()[scan].registered; }
  slam::Pose2 T_map_base(std::size_t scan) const;
  std::vector<slam::Pose3> T_map_laser() const;

  /// The scans with their points, where they lie now.
  std::vector<slam::PosedCloud> Scans() const;
  slam::PosedCloud LastScan() const;

  /// Those of the registered scans, seen from above.
  std::vector<slam::Pose2> T_map_scans() const;
  std::size_t height_count() const { return area_.height_count(); }
  const std::vector<planning::LabelledPolygon>& Area(std::size_t height) const;
  /// That area, with what is to be looked at more closely unseen.
  std::vector<planning::LabelledPolygon> AreaToLookCloser(std::size_t height) const;

  /// The reduced points, with their surfaces, of the registered scans that were taken within reach [m];
  /// none where there are none.
  std::optional<slam::AlignModel> ModelAround(const Eigen::Vector2d& p_map, double reach) const;

  /// What stands, or may stand, in the way, up to the robot's height; but for where it has stood.
  Ground LookAtGround();

 private:
  std::vector<slam::Pose3> RegisteredPoses() const;

  MissionOptions options_;
  slam::Pose3 T_base_laser_;
  slam::Mapper mapper_;
  ScanLoopArea area_;
  /// By height, as the scans lie now; those that were asked for, for a union of many scans takes long.
  mutable std::vector<std::optional<std::vector<planning::LabelledPolygon>>> areas_;
  std::vector<std::size_t> shown_;  // scans that the area knows
  std::vector<slam::PosedCloud> scans_;
  slam::Pose3 T_chain_laser_;  // the guesses' steps, one after the other, as the mapper takes odometry
  GroundMap ground_;
};

}  // namespace ariadne::experiments
