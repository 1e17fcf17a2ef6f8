#include "slam/sparse/block_matrix.h"

#include <algorithm>

namespace ariadne::slam {
namespace {

/// The block rows of each block column, ascending, the diagonal first.
struct BlockColumns {
  std::vector<std::int32_t> begins;
  std::vector<std::int32_t> rows;
};

BlockColumns SortedColumns(const BlockOrder& order, const std::vector<BlockPlace>& places) {
  // Counting sort by the column, then each short column by itself.
  std::vector<std::int32_t> begins(order.size() + 1, 0);
  for (const auto& [i, j] : places) ++begins[static_cast<std::size_t>(std::min(order[i], order[j])) + 1];
  for (std::size_t c = 0; c < order.size(); ++c) begins[c + 1] += begins[c];
  std::vector<std::int32_t> rows(places.size());
  std::vector<std::int32_t> next(begins.begin(), begins.end() - 1);
  for (const auto& [i, j] : places) {
    const auto [column, row] = std::minmax(order[i], order[j]);
    rows[static_cast<std::size_t>(next[static_cast<std::size_t>(column)]++)] = row;
  }
  BlockColumns columns;
  columns.begins.reserve(order.size() + 1);
  columns.rows.reserve(places.size() + order.size());
  for (std::size_t c = 0; c < order.size(); ++c) {
    columns.begins.push_back(static_cast<std::int32_t>(columns.rows.size()));
    columns.rows.push_back(static_cast<std::int32_t>(c));
    const auto begin = rows.begin() + begins[c], end = rows.begin() + begins[c + 1];
    std::sort(begin, end);
    for (auto row = begin; row != end; ++row) {
      if (*row != columns.rows.back()) columns.rows.push_back(*row);
    }
  }
  columns.begins.push_back(static_cast<std::int32_t>(columns.rows.size()));
  return columns;
}

}  // namespace

BlockMatrix::BlockMatrix(int block_size, BlockOrder order, const std::vector<BlockPlace>& places)
    : block_size_(block_size), order_(std::move(order)) {
  BlockColumns columns = SortedColumns(order_, places);
  block_begins_ = std::move(columns.begins);
  block_rows_ = std::move(columns.rows);
  column_begins_.reserve(static_cast<std::size_t>(size()) + 1);
  column_begins_.push_back(0);
  rows_.reserve(block_rows_.size() * static_cast<std::size_t>(block_size_ * block_size_));
  for (std::size_t column = 0; column < order_.size(); ++column) {
    const auto begin = block_rows_.begin() + block_begins_[column];
    const auto end = block_rows_.begin() + block_begins_[column + 1];
    for (int c = 0; c < block_size_; ++c) {
      for (auto row = begin; row != end; ++row) {
        for (int r = 0; r < block_size_; ++r) rows_.push_back(*row * block_size_ + r);
      }
      column_begins_.push_back(static_cast<std::int32_t>(rows_.size()));
    }
  }
  values_.assign(rows_.size(), 0.0);
}

BlockMatrix::Handle BlockMatrix::Find(std::size_t i, std::size_t j) const {
  const auto [column, row] = std::minmax(order_[i], order_[j]);
  const std::int32_t first = block_begins_[static_cast<std::size_t>(column)];
  const std::int32_t last = block_begins_[static_cast<std::size_t>(column) + 1];
  const auto found = std::lower_bound(block_rows_.begin() + first, block_rows_.begin() + last, row);
  const auto place = found - block_rows_.begin() - first;
  const auto begin =
      column_begins_[static_cast<std::size_t>(column) * static_cast<std::size_t>(block_size_)];
  return {static_cast<std::size_t>(begin + place * block_size_), (last - first) * block_size_,
          order_[i] < order_[j]};
}

void BlockMatrix::SetZero() { std::fill(values_.begin(), values_.end(), 0.0); }

std::size_t BlockMatrix::DiagonalOffset(Eigen::Index k) const {
  // The diagonal block is the first of its column of blocks.
  return static_cast<std::size_t>(column_begins_[static_cast<std::size_t>(k)] + k % block_size_);
}

void BlockMatrix::AddToDiagonal(const Eigen::VectorXd& summands) {
  for (Eigen::Index k = 0; k < size(); ++k) values_[DiagonalOffset(k)] += summands[k];
}

Eigen::VectorXd BlockMatrix::DiagonalEntries() const {
  Eigen::VectorXd diagonal(size());
  for (Eigen::Index k = 0; k < size(); ++k) diagonal[k] = values_[DiagonalOffset(k)];
  return diagonal;
}

}  // namespace ariadne::slam
