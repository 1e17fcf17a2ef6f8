#pragma once

#include <cstdint>
#include <vector>

#include "planning/path/free_space.h"

namespace ariadne::planning {

/// How far it is from one place to all others for a disc that stays within the free space.
class GeodesicField {
 public:
  /// The length of the shortest way on the raster [m]; infinity where the disc cannot go. To a place where
  /// it has no room: to a free cell next to it (2 cells), and from there.
  double To(const Eigen::Vector2d& p_map) const;

  /// The way from the start to p, pulled tight where the line of sight allows; both ends are exact. Its
  /// length is less than To(). Empty where p is not reachable.
  std::vector<Eigen::Vector2d> PathTo(const Eigen::Vector2d& p_map) const;

  /// Whether the disc can stand on the centre of a cell and get there.
  bool IsReachable(Cell cell) const {
    return space_->IsOnRaster(cell) && distance_[space_->IndexOf(cell)] != UINT32_MAX;
  }

 private:
  friend GeodesicField DistancesFrom(const FreeSpace&, const Eigen::Vector2d&, double);

  struct Arrival {
    Cell cell;
    double distance;  // infinity: none [m]
  };

  GeodesicField(const FreeSpace& space, const Eigen::Vector2d& start_map);
  void SpreadFromStart(double radius);
  Arrival ArrivalAt(const Eigen::Vector2d& p_map) const;
  std::vector<Eigen::Vector2d> RasterPathTo(const Eigen::Vector2d& p_map) const;

  const FreeSpace* space_;
  Eigen::Vector2d start_map_;
  double radius_ = 0.0;                  // [m]
  std::vector<char> free_;               // for the disc
  std::vector<std::uint32_t> distance_;  // [cells / 1024]; the largest number: not reached
};

/// Dijkstra's algorithm with 16 neighbours per cell. The space must outlive the field. A start where the
/// disc has no room (a robot that stands close to a wall) is left for the nearest free cell within 0.5 m on
/// the same side of the boundary, and the way there counts; without one, nothing is reachable. Discs
/// smaller than 0.75 cells count as that, so that no way leads through a thin wall.
///
/// Lengths exceed those of shortest ways for the disc by at most 2.8 % (between the 16 directions), and by
/// 2 cells per corner where the disc touches, since cells and not places are free. A way narrower than the
/// disc and 1.42 cells (1 cell along the raster) may be missed.
///
/// Error for a start that is no place, and a radius that is negative or not finite.
GeodesicField DistancesFrom(const FreeSpace& space, const Eigen::Vector2d& start_map, double radius);

/// Of a way through places [m].
double LengthOf(const std::vector<Eigen::Vector2d>& way);

}  // namespace ariadne::planning
