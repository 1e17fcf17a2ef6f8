#pragma once

#include <vector>

#include "slam/sparse/block_cholesky.h"

namespace ariadne::slam {

/// The blocks on the diagonal of the inverse of the matrix that a factor was made of (FactorKind
/// kSupernodal), one per block, by Takahashi's recursion: it computes only those entries of the inverse
/// where the factor has entries, at a few times the cost of a factorization. The inverse itself is dense.
std::vector<Eigen::MatrixXd> DiagonalBlocksOfInverse(const BlockCholesky& factor,
                                                     const BlockMatrix& pattern);

}  // namespace ariadne::slam
