#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/pose2.h"
#include "slam/map/grid_votes.h"

namespace ariadne::experiments {

/// What the scans must show of a place before the robot takes it for clear.
struct ClearOptions {
  double gap = 0.18;
  double within = 0.06;
  double min_leg = 1.5;
  double detour = 2.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("gap", self.gap, Unit("m"), Range{0.0, 10.0},
          "between the heights at which beams went through: where more is left, something may stand there "
          "that none has met, such as a table's edge; 0: whatever is not occupied is clear");
    visit("within", self.within, Unit("m"), Range{0.0, 1.0},
          "of a place, beams count for it: so far apart are they nearby");
    visit("min_leg", self.min_leg, Unit("m"), Range{0.0, 1000.0},
          "of a path that are worth a scan where it stops being clear; if less, another view is looked "
          "for, and if there is none, the robot goes on all the same");
    visit("detour", self.detour, Unit(""), Range{1.0, 100.0},
          "times as long as a path, one that is clear all the way is taken instead");
  }
};

/// What stands on the ground as high as the robot, and what may.
struct Ground {
  std::vector<Eigen::Vector2d> obstacles_map;  // outlines of what stands, what was met, and the fence [m]
  /// The borders of where no scan shows that nothing stands, and all of it near the robot [m].
  std::vector<Eigen::Vector2d> unclear_map;
};

/// The cells around a robot, as its scans show them. Those of a scan are made once, and anew when it lies
/// elsewhere.
class GroundMap {
 public:
  GroundMap(const slam::OccupancyGridOptions& grid, const ClearOptions& clear,
            std::vector<Eigen::Vector2d> fence_map)
      : grid_(grid), clear_(clear), fence_map_(std::move(fence_map)) {}

  /// Something stands there that the robot cannot pass, whatever the scans show.
  void AddObstacle(const Eigen::Vector2d& p_map) { met_map_.push_back(p_map); }

  /// By the scans `shown` of all, each from where it lies now; `T_map_laser` and `T_map_base` are theirs.
  Ground Look(std::span<const slam::PosedCloud> scans, std::span<const std::size_t> shown,
              std::span<const slam::Pose3> T_map_laser, std::span<const slam::Pose2> T_map_base);

 private:
  /// What a scan says of the cells around it, from where it lies now.
  struct SeenCells {
    slam::Pose3 T_map_laser;
    slam::GridPart part;
  };

  void Update(std::span<const slam::PosedCloud> scans, std::span<const std::size_t> shown,
              std::span<const slam::Pose3> T_map_laser);

  slam::OccupancyGridOptions grid_;
  ClearOptions clear_;
  std::vector<SeenCells> seen_;
  std::vector<Eigen::Vector2d> met_map_;
  std::vector<Eigen::Vector2d> fence_map_;
};

}  // namespace ariadne::experiments
