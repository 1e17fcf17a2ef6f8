#include "slam/mapper.h"

#include "slam/base/error.h"
#include "slam/extract/slice_lines.h"

namespace ariadne::slam {

Mapper::Mapper(const MapperOptions& options) : options_(options) { CheckOptions(options); }

MatchResult Mapper::AddScan(const PosedCloud& scan_odom, const MatchCallback& on_progress,
                            const std::optional<Pose3::Square>& covariance) {
  map_.scans.push_back(Prepare(scan_odom));
  map_.scans.back().guess_covariance = covariance;
  last_T_odom_laser_ = scan_odom.T_map_laser;
  if (map_.scans.size() > 1) return MatchNewScan(map_, options_.registration, options_.icp, on_progress);
  map_.scans.front().registered = true;
  MatchResult result;
  result.registered = true;
  result.T_map_laser_guess = map_.scans.front().T_map_laser;
  result.message = "master: it defines the map's coordinates";
  return result;
}

MatchResult Mapper::Finish() { return FinishMatching(map_, options_.registration, options_.icp); }

void Mapper::RestoreScan(const PosedCloud& scan_odom, const Pose3& T_map_laser, bool registered) {
  map_.scans.push_back(Prepare(scan_odom));
  map_.scans.back().T_map_laser = T_map_laser;
  map_.scans.back().registered = registered;
  last_T_odom_laser_ = scan_odom.T_map_laser;
}

MapScan Mapper::Prepare(const PosedCloud& scan_odom) const {
  const auto [min_range, max_range] = options_.scan;
  const PointCloud in_range = WithinRange(scan_odom.cloud_laser, min_range, max_range);
  if (in_range.empty()) {
    Fail("{}: none of its {} points is between scan.min_range={} and scan.max_range={} m", scan_odom.name,
         scan_odom.cloud_laser.size(), min_range, max_range);
  }
  PointCloud reduced = ToMatch(scan_odom.name, in_range);
  KdTree tree(reduced.positions);
  MapScan scan{scan_odom.name, std::move(reduced), std::move(tree), Guess(scan_odom.T_map_laser)};
  RequireSurfaces(scan, options_.icp.normal_neighbors, Parallel(options_.icp.threads));
  return scan;
}

PointCloud Mapper::ToMatch(const std::string& name, const PointCloud& in_range) const {
  if (options_.registration.points == MatchPoints::kReduced) return Reduce(in_range, options_.reduce);
  if (!in_range.organized()) {
    Fail("{}: registration.points=edges needs slices, which this file does not tell; use reduced", name);
  }
  PointCloud edges = EdgePointCloud(in_range, options_.lines);
  if (edges.empty()) Fail("{}: no lines were found in its {} slices", name, in_range.slice_begin.size());
  return edges;
}

Pose3 Mapper::Guess(const Pose3& T_odom_laser) const {
  if (map_.scans.empty()) return T_odom_laser;
  return map_.scans.back().T_map_laser * (last_T_odom_laser_.Inverse() * T_odom_laser);
}

}  // namespace ariadne::slam
