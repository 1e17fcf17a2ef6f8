#include "experiments/mission/mission_map.h"

#include "experiments/mission/fence.h"
#include "experiments/mission/laser_covariance.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {

MissionMap::MissionMap(const MissionOptions& options, const slam::Pose3& T_base_laser)
    : options_(options),
      T_base_laser_(T_base_laser),
      mapper_(options.mapper),
      area_(options.area, ParseNumbers(options.heights, "heights"), T_base_laser),
      ground_(options.obstacles, options.clear,
              FencePosts(options.limits.fence, options.obstacles.resolution)) {
  CheckOptions(options_, "mission.");
  areas_.resize(area_.height_count());
}

slam::MatchResult MissionMap::AddScan(const std::string& name, slam::PointCloud cloud_laser,
                                      const slam::Pose2& T_map_base_guess,
                                      const std::optional<slam::Pose2::Square>& covariance) {
  const slam::Pose3 T_map_laser_guess = slam::ToPose3(T_map_base_guess) * T_base_laser_;
  T_chain_laser_ =
      scans_.empty() ? T_map_laser_guess
                     : T_chain_laser_ * (mapper_.scans().back().T_map_laser.Inverse() * T_map_laser_guess);
  slam::PosedCloud scan{name, std::move(cloud_laser), T_chain_laser_};
  const slam::ScanGraphOptions& floor = options_.mapper.registration.graph;
  std::optional<slam::Pose3::Square> of_laser;
  if (covariance)
    of_laser = LaserCovariance(*covariance, T_base_laser_, floor.floor_height, floor.floor_tilt);
  slam::MatchResult match = mapper_.AddScan(scan, {}, of_laser);
  scan.T_map_laser = mapper_.scans().back().T_map_laser;
  if (mapper_.scans().back().registered) {
    shown_.push_back(scans_.size());
    area_.AddScan(scan);
  }
  scans_.push_back(std::move(scan));
  areas_.assign(area_.height_count(), {});
  return match;
}

slam::MatchResult MissionMap::Finish() {
  slam::MatchResult match = mapper_.Finish();
  areas_.assign(area_.height_count(), {});
  return match;
}

slam::Pose2 MissionMap::T_map_base(std::size_t scan) const {
  return FromAbove(mapper_.scans()[scan].T_map_laser * T_base_laser_.Inverse());
}

std::vector<slam::Pose3> MissionMap::T_map_laser() const {
  std::vector<slam::Pose3> poses;
  for (const slam::MapScan& scan : mapper_.scans()) poses.push_back(scan.T_map_laser);
  return poses;
}

std::vector<slam::PosedCloud> MissionMap::Scans() const {
  std::vector<slam::PosedCloud> scans = scans_;
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i].T_map_laser = mapper_.scans()[i].T_map_laser;
  return scans;
}

slam::PosedCloud MissionMap::LastScan() const {
  slam::PosedCloud scan = scans_.back();
  scan.T_map_laser = mapper_.scans().back().T_map_laser;
  return scan;
}

std::vector<slam::Pose3> MissionMap::RegisteredPoses() const {
  std::vector<slam::Pose3> poses;
  for (const std::size_t i : shown_) poses.push_back(mapper_.scans()[i].T_map_laser);
  return poses;
}

std::vector<slam::Pose2> MissionMap::T_map_scans() const {
  std::vector<slam::Pose2> poses;
  for (const slam::Pose3& T_map_laser : RegisteredPoses()) poses.push_back(FromAbove(T_map_laser));
  return poses;
}

const std::vector<planning::LabelledPolygon>& MissionMap::Area(std::size_t height) const {
  if (!areas_[height]) areas_[height] = area_.At(height, RegisteredPoses());
  return *areas_[height];
}

std::vector<planning::LabelledPolygon> MissionMap::AreaToLookCloser(std::size_t height) const {
  return area_.ToLookCloser(Area(height), height, RegisteredPoses());
}

std::optional<slam::AlignModel> MissionMap::ModelAround(const Eigen::Vector2d& p_map, double reach) const {
  std::vector<std::size_t> members;
  for (const std::size_t i : shown_) {
    if ((mapper_.scans()[i].T_map_laser.translation.head<2>() - p_map).norm() < reach) members.push_back(i);
  }
  if (members.empty()) return {};
  return slam::UnionInMap(mapper_.scans(), members);
}

Ground MissionMap::LookAtGround() {
  std::vector<slam::Pose2> T_map_bases;
  for (const std::size_t i : shown_) T_map_bases.push_back(T_map_base(i));
  return ground_.Look(scans_, shown_, RegisteredPoses(), T_map_bases);
}

}  // namespace ariadne::experiments
