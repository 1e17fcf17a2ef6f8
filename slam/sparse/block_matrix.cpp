#include "slam/sparse/block_matrix.h"

#include <algorithm>

namespace ariadne::slam {
namespace {

/// The places below the diagonal in the order of elimination, by columns, each once, with the diagonal.
std::vector<std::pair<std::int32_t, std::int32_t>> SortedColumns(const BlockOrder& order,
                                                                 const std::vector<BlockPlace>& places) {
  std::vector<std::pair<std::int32_t, std::int32_t>> column_row;
  column_row.reserve(places.size() + order.size());
  for (const auto& [i, j] : places) column_row.push_back(std::minmax(order[i], order[j]));
  for (std::size_t i = 0; i < order.size(); ++i) {
    column_row.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(i));
  }
  std::sort(column_row.begin(), column_row.end());
  column_row.erase(std::unique(column_row.begin(), column_row.end()), column_row.end());
  return column_row;
}

}  // namespace

BlockMatrix::BlockMatrix(int block_size, BlockOrder order, const std::vector<BlockPlace>& places)
    : block_size_(block_size), order_(std::move(order)), block_begins_(order_.size() + 1, 0) {
  for (const auto& [column, row] : SortedColumns(order_, places)) {
    ++block_begins_[static_cast<std::size_t>(column) + 1];
    block_rows_.push_back(row);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) block_begins_[i + 1] += block_begins_[i];
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
