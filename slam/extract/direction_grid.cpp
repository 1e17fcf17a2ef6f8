#include "slam/extract/direction_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/extract/slice_lines.h"
#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

constexpr double kLeastStep = RadFromDeg(0.05);  // finer than any scanner's, and cells remain few
constexpr double kDefaultStep = RadFromDeg(1.0);

/// From the right (0) over ahead to the left (pi).
double Bearing(const Eigen::Vector3d& p) { return std::atan2(std::hypot(p.x(), p.z()), -p.y()); }

double Median(std::vector<double> values, double otherwise) {
  if (values.empty()) return otherwise;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::size_t EndOf(const PointCloud& cloud, std::size_t slice) {
  return slice + 1 < cloud.slice_begin.size() ? cloud.slice_begin[slice + 1] : cloud.size();
}

double BeamStep(const PointCloud& cloud_laser) {
  std::vector<double> steps;
  for (std::size_t s = 0; s < cloud_laser.slice_begin.size(); ++s) {
    for (std::size_t i = cloud_laser.slice_begin[s] + 1; i < EndOf(cloud_laser, s); ++i) {
      steps.push_back(std::abs(Bearing(cloud_laser.positions[i]) - Bearing(cloud_laser.positions[i - 1])));
    }
  }
  return std::max(kLeastStep, Median(std::move(steps), kDefaultStep));
}

/// Between the middles of successive slices.
double PitchStep(const PointCloud& cloud_laser) {
  std::vector<double> pitches, steps;
  for (std::size_t s = 0; s < cloud_laser.slice_begin.size(); ++s) {
    const std::size_t begin = cloud_laser.slice_begin[s], end = EndOf(cloud_laser, s);
    if (begin == end) continue;
    const Eigen::Vector3d& p = cloud_laser.positions[begin + (end - begin) / 2];
    pitches.push_back(std::atan2(p.z(), p.x()));
  }
  for (std::size_t s = 1; s < pitches.size(); ++s) {
    steps.push_back(std::abs(WrapAngle(pitches[s] - pitches[s - 1])));
  }
  return std::max(kLeastStep, Median(std::move(steps), kDefaultStep));
}

std::size_t Bin(double angle, double step, std::size_t bins) {
  return std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, angle / step)));
}

}  // namespace

DirectionGrid::DirectionGrid(std::size_t rows, std::size_t columns, std::vector<std::size_t> cells)
    : rows_(rows), columns_(columns), cells_(std::move(cells)), begin_(rows * columns + 1, 0) {
  for (const std::size_t cell : cells_) ++begin_[cell + 1];
  for (std::size_t cell = 0; cell < rows * columns; ++cell) begin_[cell + 1] += begin_[cell];
  points_.resize(cells_.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t p = 0; p < cells_.size(); ++p)
    points_[next[cells_[p]]++] = static_cast<std::uint32_t>(p);
}

DirectionGrid DirectionGrid::OfSlices(const PointCloud& cloud_laser) {
  RequireSlices(cloud_laser, "a grid of slices");
  const double step = BeamStep(cloud_laser);
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::numbers::pi / step)) + 1;
  std::vector<std::size_t> cells(cloud_laser.size());
  for (std::size_t s = 0; s < cloud_laser.slice_begin.size(); ++s) {
    for (std::size_t i = cloud_laser.slice_begin[s]; i < EndOf(cloud_laser, s); ++i) {
      // Half a step: the beams are in the middle of the cells.
      cells[i] = s * columns + Bin(Bearing(cloud_laser.positions[i]) + 0.5 * step, step, columns);
    }
  }
  DirectionGrid grid(cloud_laser.slice_begin.size(), columns, std::move(cells));
  grid.row_step_ = PitchStep(cloud_laser);
  grid.column_step_ = step;
  return grid;
}

DirectionGrid DirectionGrid::OfDirections(const PointCloud& cloud_laser, double step) {
  const auto rows = static_cast<std::size_t>(std::ceil(std::numbers::pi / step));
  const auto columns = static_cast<std::size_t>(std::ceil(2.0 * std::numbers::pi / step));
  std::vector<std::size_t> cells;
  cells.reserve(cloud_laser.size());
  for (const Eigen::Vector3d& p : cloud_laser.positions) {
    const double elevation = std::atan2(p.z(), std::hypot(p.x(), p.y())) + 0.5 * std::numbers::pi;
    const double azimuth = std::atan2(p.y(), p.x()) + std::numbers::pi;
    cells.push_back(Bin(elevation, step, rows) * columns + Bin(azimuth, step, columns));
  }
  DirectionGrid grid(rows, columns, std::move(cells));
  grid.all_around_ = true;
  grid.row_step_ = step;
  grid.column_step_ = step;
  return grid;
}

std::span<const std::uint32_t> DirectionGrid::At(std::ptrdiff_t row, std::ptrdiff_t column) const {
  const auto columns = static_cast<std::ptrdiff_t>(columns_);
  if (all_around_) column = (column % columns + columns) % columns;
  if (column < 0 || column >= columns) return {};
  const auto cell = static_cast<std::size_t>(row * columns + column);
  return std::span(points_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
}

}  // namespace ariadne::slam
