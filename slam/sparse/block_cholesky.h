#pragma once

#include <memory>

#include "slam/sparse/block_matrix.h"

namespace ariadne::slam {

/// How the columns of the factor are kept.
enum class FactorKind {
  kBest,       // whichever is faster, by the number of operations per entry
  kSupernodal  // dense panels of columns
};

/// The Cholesky factor L of a BlockMatrix, L L^T, by CHOLMOD. The symbolic work is done once per pattern.
class BlockCholesky {
 public:
  explicit BlockCholesky(const BlockMatrix& pattern, FactorKind kind = FactorKind::kBest);
  ~BlockCholesky();
  BlockCholesky(BlockCholesky&&) noexcept;
  BlockCholesky& operator=(BlockCholesky&&) noexcept;

  /// False where the matrix (of that pattern) is not positive definite to rounding. Error where there is
  /// not enough memory.
  bool Factorize(const BlockMatrix& matrix);

  /// Solves for one or more right sides, in the order of elimination. After a successful Factorize.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& right_sides) const;

  /// The entries of the factor.
  double entries() const;

 private:
  friend std::vector<Eigen::MatrixXd> DiagonalBlocksOfInverse(const BlockCholesky& factor,
                                                              const BlockMatrix& pattern);
  struct Impl;  // keeps CHOLMOD out of the headers
  std::unique_ptr<Impl> impl_;
};

}  // namespace ariadne::slam
