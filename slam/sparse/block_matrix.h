#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ariadne::slam {

/// A pair of blocks that are coupled: a place off the diagonal, on either side of it.
using BlockPlace = std::pair<std::size_t, std::size_t>;

/// The place of each block in the order of elimination.
using BlockOrder = std::vector<std::int32_t>;

/// An order that keeps the factor sparse: approximate minimum degree on the graph of the blocks, which is
/// smaller than that of the scalars by the block size and gives as good an order.
BlockOrder OrderBlocks(std::size_t blocks, const std::vector<BlockPlace>& places);

/// A symmetric matrix of square blocks, stored in the order of elimination, of which only the lower half is
/// kept (and whole blocks on the diagonal), where it is not zero. A vector that belongs to it has block i
/// at row block_size * order[i].
class BlockMatrix {
 public:
  /// Where a block lies in the values.
  struct Handle {
    std::size_t offset = 0;
    std::int32_t stride = 0;  // from column to column
    bool transposed = false;  // the block that is kept is the one at the mirrored place
  };

  /// `places` may hold a place twice, also mirrored.
  BlockMatrix(int block_size, BlockOrder order, const std::vector<BlockPlace>& places);

  int block_size() const { return block_size_; }
  std::size_t blocks() const { return order_.size(); }
  Eigen::Index size() const { return block_size_ * static_cast<Eigen::Index>(order_.size()); }
  const BlockOrder& order() const { return order_; }
  /// The row at which block i begins.
  Eigen::Index row(std::size_t i) const { return block_size_ * static_cast<Eigen::Index>(order_[i]); }

  Handle Diagonal(std::size_t i) const { return Find(i, i); }
  /// A place that was given to the constructor, or one on the diagonal.
  Handle Find(std::size_t i, std::size_t j) const;

  void SetZero();

  /// Adds a block of which Find() has told the place. On the diagonal `block` is symmetric.
  template <int kSize>
  void Add(const Handle& place, const Eigen::Matrix<double, kSize, kSize>& block) {
    using Map = Eigen::Map<Eigen::Matrix<double, kSize, kSize>, Eigen::Unaligned, Eigen::OuterStride<>>;
    Map kept(values_.data() + place.offset, Eigen::OuterStride<>(place.stride));
    if (place.transposed) {
      kept += block.transpose();
    } else {
      kept += block;
    }
  }

  // Compressed columns, in the order of elimination: what CHOLMOD takes.
  const std::vector<std::int32_t>& column_begins() const { return column_begins_; }
  const std::vector<std::int32_t>& rows() const { return rows_; }
  const std::vector<double>& values() const { return values_; }
  std::vector<double>& values() { return values_; }

  /// Adds factor[k] to each diagonal entry k, in the order of elimination.
  void AddToDiagonal(const Eigen::VectorXd& summands);
  Eigen::VectorXd DiagonalEntries() const;

 private:
  std::size_t DiagonalOffset(Eigen::Index k) const;

  int block_size_;
  BlockOrder order_;
  std::vector<std::int32_t> block_begins_;  // per block column, into block_rows_
  std::vector<std::int32_t> block_rows_;    // ascending within a column; the first is the diagonal
  std::vector<std::int32_t> column_begins_;
  std::vector<std::int32_t> rows_;
  std::vector<double> values_;
};

}  // namespace ariadne::slam
