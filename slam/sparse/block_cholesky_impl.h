#pragma once

#include "slam/sparse/block_cholesky.h"
#include "slam/sparse/cholmod.h"

namespace ariadne::slam {

struct BlockCholesky::Impl {
  CholmodContext context;
  FactorPtr factor{nullptr, FreeFactor{nullptr}};
  double entries = 0.0;
};

/// A view of the lower half as CHOLMOD takes it. Refers to the matrix.
cholmod_sparse ViewOf(const BlockMatrix& matrix);

}  // namespace ariadne::slam
