#include "slam/extract/hough_accumulator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr double kMaxCells = 8000.0;      // 128 MB
constexpr std::int16_t kClosed = -16000;  // stays below 0 and above overflow, whatever is taken back

}  // namespace

HoughAccumulator::HoughAccumulator(std::span<const Eigen::Vector2d> points, double cells_per_meter) {
  if (points.size() > kMaxPoints) {
    Fail("{} points are too many for the Hough transform, {} is the most; reduce them", points.size(),
         kMaxPoints);
  }
  if (points.empty()) return;
  Eigen::Vector2d low = points.front(), high = points.front();
  for (const Eigen::Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  corner_ = low;
  max_rho_ = (high - low).norm();
  const double cells = std::ceil(cells_per_meter * max_rho_);
  if (cells > kMaxCells) {
    Fail(
        "points over {} m need {} x {} Hough cells, {} each way is the most; lower hough.max_distance or "
        "hough.cells_per_meter",
        max_rho_, cells, cells, kMaxCells);
  }
  cells_ = std::max<std::size_t>(2, static_cast<std::size_t>(cells));
  const double scale = 0.5 * static_cast<double>(cells_) / std::max(max_rho_, 1e-12);
  for (std::size_t t = 0; t < cells_; ++t) {
    const double theta = (static_cast<double>(t) / static_cast<double>(cells_) - 0.5) * std::numbers::pi;
    cells_per_x_.push_back(static_cast<float>(scale * std::cos(theta)));
    cells_per_y_.push_back(static_cast<float>(scale * std::sin(theta)));
  }
  votes_.assign(cells_ * cells_, 0);
  AddVotes(points, 1);
  for (std::size_t t = 0; t < cells_; ++t) row_bounds_.push_back(MaximumOf(t));
}

void HoughAccumulator::AddVotes(std::span<const Eigen::Vector2d> points, std::int16_t votes) {
  std::vector<float> x, y;
  for (const Eigen::Vector2d& p : points) {
    x.push_back(static_cast<float>(p.x() - corner_.x()));
    y.push_back(static_cast<float>(p.y() - corner_.y()));
  }
  std::vector<std::int32_t> cells(points.size());
  for (std::size_t t = 0; t < cells_; ++t) {  // row by row: a row stays in the cache
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = RhoCell(t, x[i], y[i]);
    std::int16_t* const row = &votes_[t * cells_];
    for (const std::int32_t cell : cells) row[cell] = static_cast<std::int16_t>(row[cell] + votes);
  }
}

std::int32_t HoughAccumulator::RhoCell(std::size_t theta_cell, float x, float y) const {
  const auto cells = static_cast<std::int32_t>(cells_);
  const float place = cells_per_x_[theta_cell] * x + cells_per_y_[theta_cell] * y;
  return std::min(static_cast<std::int32_t>(place + 0.5F * static_cast<float>(cells)), cells - 1);
}

std::span<std::int16_t> HoughAccumulator::Row(std::size_t theta_cell) {
  return std::span(votes_).subspan(theta_cell * cells_, cells_);
}

std::int16_t HoughAccumulator::MaximumOf(std::size_t theta_cell) {
  std::int16_t maximum = kClosed;
  for (const std::int16_t votes : Row(theta_cell)) maximum = std::max(maximum, votes);
  return maximum;
}

std::size_t HoughAccumulator::HighestRow() {
  std::size_t best = 0;
  std::int16_t votes = std::numeric_limits<std::int16_t>::min();
  const auto look_at = [&](std::size_t row) {
    row_bounds_[row] = MaximumOf(row);
    if (row_bounds_[row] < votes || (row_bounds_[row] == votes && row > best)) return;
    best = row;
    votes = row_bounds_[row];
  };
  const std::int16_t bound = *std::ranges::max_element(row_bounds_);
  look_at(static_cast<std::size_t>(std::ranges::find(row_bounds_, bound) - row_bounds_.begin()));
  for (std::size_t row = 0; row < cells_;
       ++row) {  // few: only where the bound promises more than was found
    if (row_bounds_[row] > votes || (row_bounds_[row] == votes && row < best)) look_at(row);
  }
  return best;
}

HoughAccumulator::Peak HoughAccumulator::Highest() {
  if (row_bounds_.empty()) return {};
  const std::size_t row = HighestRow();
  const std::int16_t votes = row_bounds_[row];
  const auto cell = static_cast<std::size_t>(std::ranges::find(Row(row), votes) - Row(row).begin());
  const auto cells = static_cast<double>(cells_);
  const double theta = (static_cast<double>(row) / cells - 0.5) * std::numbers::pi;
  const double rho = (2.0 * (static_cast<double>(cell) + 0.5) / cells - 1.0) * max_rho_;
  const Eigen::Vector2d normal(std::cos(theta), std::sin(theta));
  return {votes, row, cell, theta, rho + normal.dot(corner_)};
}

void HoughAccumulator::Withdraw(std::span<const Eigen::Vector2d> points) { AddVotes(points, -1); }

void HoughAccumulator::Close(const Peak& peak) {
  votes_[peak.theta_cell * cells_ + peak.rho_cell] = kClosed;
}

}  // namespace ariadne::slam
