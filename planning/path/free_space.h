#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/polygon2.h"

namespace ariadne::planning {

struct FreeSpaceOptions {
  double resolution = 0.1;
  double exact_within = 1.0;
  int max_cells = 20000000;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, Unit("m"), Range{0.005, 10.0},
          "of the raster; a third of the robot's half width loses 4 mm of a door's width");
    visit("exact_within", self.exact_within, Unit("m"), Range{0.0, 100.0},
          "of a boundary, clearances are exact; farther away they are too small by up to 1.41 cells. "
          "Above the radius of any disc that is asked for");
    visit("max_cells", self.max_cells, Unit(""), Range{1, 1000000000}, "4 bytes each; 100 MB in all");
  }
};

/// A place on the raster.
struct Cell {
  int column = 0;
  int row = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// How far a place of the known free area is from its nearest boundary, by a raster of squared distances:
/// exact ones near the boundary, from a Euclidean distance transform (Felzenszwalb, Huttenlocher 2012)
/// elsewhere. Where two polygons touch, their common edge is a boundary; so is every obstacle, a place.
class FreeSpace {
 public:
  /// The area is the inside of polygons that do not overlap; obstacles outside of it do not matter. Error
  /// for corners and obstacles that are no places, and for an area with too many cells.
  explicit FreeSpace(std::span<const slam::Polygon2> area, const FreeSpaceOptions& options = {},
                     std::span<const Eigen::Vector2d> obstacles_map = {});

  /// The distance to the nearest boundary [m]; 0 outside. Never more than that (but for 1e-5 m of
  /// rounding), so that what is free here is free. Less by at most resolution^2 / (7 clearance) where one
  /// place of the boundary is the nearest, and 0.71 cells midway between several; 1.41 cells more beyond
  /// exact_within; 0 in some places nearer to a boundary than 0.71 cells.
  ///
  /// Between the centres c_i of cells squares are interpolated: sum w_i |c_i - q|^2 = |p - q|^2 + V for
  /// any q, so that the sum of w_i clearance_i^2, less V, is no more than the square of the distance of p.
  double Clearance(const Eigen::Vector2d& p_map) const;

  /// Whether a disc around p lies within the area. Exact, by the edges near p, where the clearance leaves
  /// it open and the radius is from 0.71 cells to exact_within: half a cell matters in doors.
  bool IsFree(const Eigen::Vector2d& p_map, double radius) const;

  /// Whether a disc can move straight from one place to another. Looks every quarter of a cell, between
  /// which the clearance can fall below the radius by step^2 / (8 radius): 0.3 mm for 0.1 m and 0.3 m.
  bool IsWayFree(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map, double radius) const;

  /// Exact, by all edges.
  bool Contains(const Eigen::Vector2d& p_map) const;

  /// How often the segment meets a boundary; exact, by all edges.
  int CountCrossings(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map) const;

  /// Of the centre of a cell, which must be on the raster [m].
  double ClearanceAt(Cell cell) const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double resolution() const { return resolution_; }
  bool IsOnRaster(Cell cell) const {
    return cell.column >= 0 && cell.column < columns_ && cell.row >= 0 && cell.row < rows_;
  }
  Cell CellOf(const Eigen::Vector2d& p_map) const;  // maybe off the raster
  Eigen::Vector2d CentreOf(Cell cell) const;
  std::size_t IndexOf(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.column);
  }

  /// Corners of the raster, which is a cell larger than the area on each side [m].
  Eigen::Vector2d lowest() const { return lowest_; }
  Eigen::Vector2d highest() const { return lowest_ + resolution_ * Eigen::Vector2d(columns_, rows_); }

 private:
  struct Segment {
    Eigen::Vector2d from, to;
  };

  struct Bin {
    int column, row;
  };

  Bin BinOf(const Eigen::Vector2d& p_map) const;
  void FillBins();
  bool IsFarFromEdges(const Eigen::Vector2d& p_map, double radius) const;
  void SetSize(const FreeSpaceOptions& options);
  void AddObstacles(std::span<const Eigen::Vector2d> obstacles_map);
  void FindExactDistances(const Segment& edge, double reach);
  void FindFarDistances(double exact_within);
  void MarkOutside();

  double resolution_, exact_within_;
  int columns_ = 0, rows_ = 0;
  Eigen::Vector2d lowest_ = Eigen::Vector2d::Zero();
  std::vector<Segment> edges_;
  int bin_columns_ = 0, bin_rows_ = 0;
  std::vector<std::uint32_t> bin_begin_, bin_edges_;  // the edges of bin i are bin_edges_[bin_begin_[i]...]
  std::vector<float> squares_;  // of the distance from the centre to the boundary [m^2]; negative outside
};

}  // namespace ariadne::planning
