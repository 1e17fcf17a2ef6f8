#pragma once

#include <optional>
#include <vector>

#include "slam/extract/detect_lines.h"
#include "slam/matching/match.h"
#include "slam/matching/match_options.h"
#include "slam/reduce/reduce.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Which points of a scan are measurements.
struct ScanFilterOptions {
  double min_range = 0.5;
  double max_range = 32.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("min_range", self.min_range, Unit("m"), Range{0.0, 1e3},
          "nearer points are dropped: they are the robot itself, or failed measurements");
    visit("max_range", self.max_range, Unit("m"), Range{0.0, 1e6},
          "farther points are dropped: scanners store no-returns as their largest range");
  }
};

/// The defaults are what has been most accurate on simulated and real scans;
/// experiments/configs/register_2003.yaml has those of the paper.
struct MapperOptions {
  ScanFilterOptions scan;
  ReduceOptions reduce{.method = ReduceMethod::kVoxelMean};
  LineOptions lines;
  AlignOptions icp{.metric = Metric::kPlaneToPlane,
                   .max_distance = 0.2,
                   .start_distance = 1.0,
                   .kernel = RobustKernel::kCauchy};
  MatchOptions registration;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scan", self.scan, "which points of a scan are measurements");
    visit("reduce", self.reduce, "how points are made fewer before matching");
    visit("lines", self.lines, "how lines are found, with registration.points=edges");
    visit("icp", self.icp, "how one cloud is aligned to another");
    visit("registration", self.registration, "which clouds are aligned to which");
  }
};

/// Turns a stream of scans into a consistent map: filters, reduces and registers scan by scan.
class Mapper {
 public:
  explicit Mapper(const MapperOptions& options);

  /// Adds a scan, whose pose is the odometry's: only its change since the scan before is used. The first
  /// scan is the master: it stays at its pose, and defines the map's coordinate system. Who knows how good
  /// that change is gives its covariance, in the tangent space of the scan's pose and positive definite;
  /// the methods graph and joint hold the scan by it where surfaces do not.
  MatchResult AddScan(const PosedCloud& scan_odom, const MatchCallback& on_progress = {},
                      const std::optional<Pose3::Square>& covariance = {});

  /// Makes the poses of all scans agree once more, when no more scans come (FinishMatching).
  MatchResult Finish();

  /// Puts back a scan that an earlier run has added, at the pose that it had come to.
  void RestoreScan(const PosedCloud& scan_odom, const Pose3& T_map_laser, bool registered);
  /// Puts back what the earlier run knew of how the scans lie to each other; after the scans.
  void RestoreGraph(const ScanGraph& graph) { map_.graph = graph; }

  const std::vector<MapScan>& scans() const { return map_.scans; }
  /// With the methods graph and joint.
  const ScanGraph& graph() const { return map_.graph; }
  const MapperOptions& options() const { return options_; }

 private:
  MapScan Prepare(const PosedCloud& scan_odom) const;
  PointCloud ToMatch(const std::string& name, const PointCloud& in_range) const;
  Pose3 Guess(const Pose3& T_odom_laser) const;

  MapperOptions options_;
  ScanMap map_;
  Pose3 last_T_odom_laser_;
};

}  // namespace ariadne::slam
