#pragma once

#include <span>
#include <vector>

#include "planning/polygon/labelled_union.h"
#include "planning/polygon/scan_polygon.h"
#include "planning/polygon/sparse_edges.h"

namespace ariadne::experiments {

struct ScanLoopAreaOptions {
  planning::ScanPolygonOptions polygon;
  planning::LabelledUnionOptions united;
  planning::SparseEdgeOptions sparse;
  double max_gap = 10.0;
  double stand_radius = 0.5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("polygon", self.polygon, "what a scan shows to be free");
    visit("united", self.united, "how the scans' polygons are united");
    visit("sparse", self.sparse, "which walls are to be looked at more closely");
    visit("max_gap", self.max_gap, Unit("deg"), Range{0.1, 360.0},
          "between bearings at which a scan shows something at the height, to be joined by one edge. Where "
          "a thing lower than the slice hides the wall behind it, that edge may cut through walls, and a "
          "union never takes back what was free; so nothing is free in wider gaps. 360: the paper's (4.2)");
    visit(
        "stand_radius", self.stand_radius, Unit("m"), Range{0.05, 5.0},
        "free around the robot's middle and its scanner where it has stood, but not beyond walls that it "
        "has seen: half its diagonal, in which it has turned. With less, the way from there into what the "
        "scan shows is too narrow: near its sides it sees nothing as high as 1.5 m");
  }
};

/// What is known to be free at some heights after some scans, made anew from the scans' latest poses.
class ScanLoopArea {
 public:
  /// Heights above the floor [m].
  ScanLoopArea(const ScanLoopAreaOptions& options, std::vector<double> heights,
               const slam::Pose3& T_base_laser);

  /// Finds the scan's lines; its pose says which points are at the heights.
  void AddScan(const slam::PosedCloud& scan);

  std::size_t height_count() const { return heights_.size(); }

  /// One area per height, for one pose per scan.
  std::vector<planning::LabelledPolygon> At(std::size_t height,
                                            std::span<const slam::Pose3> T_map_laser) const;

  /// Such an area, with the walls unseen that no scan has seen closely enough (`sparse`).
  std::vector<planning::LabelledPolygon> ToLookCloser(std::span<const planning::LabelledPolygon> area,
                                                      std::size_t height,
                                                      std::span<const slam::Pose3> T_map_laser) const;

 private:
  planning::LabelledPolygon Stand(const slam::Pose3& T_map_laser,
                                  std::span<const planning::LabelledPolygon> scans) const;

  ScanLoopAreaOptions options_;
  std::vector<double> heights_;
  slam::Pose3 T_base_laser_;
  std::vector<std::vector<std::vector<planning::SliceLine>>> lines_;  // of each height, of each scan
};

/// A pose of the laser or the base as seen from above.
slam::Pose2 FromAbove(const slam::Pose3& pose);

/// How far a place is from the nearest edge, of those that are seen if `seen_only`; infinite without any.
double DistanceToEdges(const Eigen::Vector2d& p_map, std::span<const planning::LabelledPolygon> area,
                       bool seen_only);

}  // namespace ariadne::experiments
