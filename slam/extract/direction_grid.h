#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// The points of a scan in cells of their direction, so that points that are neighbours as the scanner sees
/// them are found at once. A cell may hold none or several.
class DirectionGrid {
 public:
  /// Rows are the slices of an organized cloud, columns bearings within the slice; a column is as wide as
  /// beams are mostly apart. Error where the cloud is not organized.
  static DirectionGrid OfSlices(const PointCloud& cloud_laser);

  /// Rows are elevations, columns azimuths all around, both `step` [rad] wide. For points in any order.
  static DirectionGrid OfDirections(const PointCloud& cloud_laser, double step);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t row(std::size_t point) const { return cells_[point] / columns_; }
  std::size_t column(std::size_t point) const { return cells_[point] % columns_; }
  /// Between neighbouring rows and columns, as an angle from the scanner [rad].
  double row_step() const { return row_step_; }
  double column_step() const { return column_step_; }

  /// Calls visit(point) for the points of the cells up to that many rows and columns away, every
  /// `stride`-th of them, the point's own cell included.
  template <typename Visitor>
  void Visit(std::size_t point, std::size_t rows, std::size_t columns, std::size_t stride,
             const Visitor& visit) const {
    const auto reach = static_cast<std::ptrdiff_t>(rows), across = static_cast<std::ptrdiff_t>(columns);
    const auto step = static_cast<std::ptrdiff_t>(stride);
    const auto r0 = static_cast<std::ptrdiff_t>(row(point)),
               c0 = static_cast<std::ptrdiff_t>(column(point));
    for (std::ptrdiff_t r = r0 - reach / step * step; r <= r0 + reach; r += step) {
      if (r < 0 || r >= static_cast<std::ptrdiff_t>(rows_)) continue;
      for (std::ptrdiff_t c = c0 - across / step * step; c <= c0 + across; c += step) {
        for (const std::uint32_t p : At(r, c)) visit(static_cast<std::size_t>(p));
      }
    }
  }

 private:
  DirectionGrid(std::size_t rows, std::size_t columns, std::vector<std::size_t> cells);
  std::span<const std::uint32_t> At(std::ptrdiff_t row, std::ptrdiff_t column) const;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  bool all_around_ = false;  // the last column is beside the first
  double row_step_ = 0.0;
  double column_step_ = 0.0;
  std::vector<std::size_t> cells_;    // of each point
  std::vector<std::uint32_t> begin_;  // of each cell, into points_
  std::vector<std::uint32_t> points_;
};

}  // namespace ariadne::slam
