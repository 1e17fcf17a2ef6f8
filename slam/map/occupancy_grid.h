#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "slam/base/options.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct OccupancyGridOptions {
  double resolution = 0.05;
  double min_height = 0.1;
  double max_height = 1.8;
  double max_range = 0.0;
  double hit = 0.85;
  double miss = 0.4;
  double most_for = 3.5;
  double most_against = 3.5;
  double doubt = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, Unit("m"), Range{0.001, 100.0},
          "edge of a cell; 5 cm is what ROS's maps have");
    visit("min_height", self.min_height, Unit("m"), Range{-1000.0, 1000.0},
          "z of the map above which points are obstacles: above the floor and its noise");
    visit("max_height", self.max_height, Unit("m"), Range{-1000.0, 1000.0},
          "z of the map up to which they are: what a robot with its scanner does not reach is none");
    visit("max_range", self.max_range, Unit("m"), Range{0.0, 1000.0},
          "of a beam: a longer one shows free space up to here, and nothing at its end; 0: none is too "
          "long");
    visit("hit", self.hit, Unit("log odds"), Range{0.01, 10.0},
          "for a cell in which a scan has points; OctoMap's, as the other two");
    visit("miss", self.miss, Unit("log odds"), Range{0.01, 10.0},
          "against a cell that beams of a scan only went through");
    visit("most_for", self.most_for, Unit("log odds"), Range{0.01, 100.0},
          "more is not believed, so that what has changed can be seen");
    visit("most_against", self.most_against, Unit("log odds"), Range{0.01, 100.0},
          "likewise; with less than hit, whatever the last scan has points in is occupied");
    visit("doubt", self.doubt, Unit("m"), Range{0.0, 10.0},
          "so far from what stands, cells that no beam has passed at its heights, nor a cell beside them, "
          "count as occupied: the far edge of a table lies between two rows of a scan");
  }
};

enum class Occupancy { kUnknown, kFree, kOccupied };

/// A grid over the plan of a map, cell by cell, rows from low y to high y. The lower left corner is at a
/// multiple of the resolution.
struct OccupancyGrid {
  double resolution = 0.0;                               // [m]
  Eigen::Vector2d origin_map = Eigen::Vector2d::Zero();  // of the lower left corner [m]
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<float> log_odds;  // of being occupied; 0 where nothing was seen

  float LogOdds(std::size_t column, std::size_t row) const { return log_odds[row * columns + column]; }
  Occupancy At(std::size_t column, std::size_t row) const;
};

/// Each scan has one vote per cell: for it where the scan has points between the heights, else against it
/// where the part of a beam that is between them goes through. So a wall that is seen at a grazing angle is
/// not wiped out by the many beams that pass close to it, and the floor that is seen frees the space over
/// it. A beam speaks against a cell with points (of any scan) only at their heights, to half a cell and a
/// 32nd of the grid's: one over a table does not say that the table is not there. Votes are added up as log
/// odds. Error where no beam is between the heights, where a place is not finite, or the grid would need
/// more than 100 million cells.
OccupancyGrid MakeOccupancyGrid(std::span<const PosedCloud> scans,
                                const OccupancyGridOptions& options = {});

}  // namespace ariadne::slam
