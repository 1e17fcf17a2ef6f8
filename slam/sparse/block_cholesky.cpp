#include "slam/sparse/block_cholesky.h"

#include "slam/base/blas_guard.h"
#include "slam/base/error.h"
#include "slam/sparse/block_cholesky_impl.h"

namespace ariadne::slam {
namespace {

void CheckMemory(const cholmod_common& common) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY) Fail("the factor of the graph does not fit into the memory");
  if (common.status < 0) Fail("CHOLMOD has failed with status {}", common.status);
}

cholmod_dense ViewOf(Eigen::MatrixXd& matrix) {
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(matrix.rows());
  view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.size());
  view.d = view.nrow;
  view.x = matrix.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

/// Takes the matrix in the order in which it is.
void KeepOrder(cholmod_common& common) {
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = 0;
}

}  // namespace

cholmod_sparse ViewOf(const BlockMatrix& matrix) {
  // CHOLMOD does not write to a matrix that it factorizes, but its type has no word for that.
  auto& m = const_cast<BlockMatrix&>(matrix);
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size());
  view.nzmax = matrix.values().size();
  view.p = const_cast<std::int32_t*>(matrix.column_begins().data());
  view.i = const_cast<std::int32_t*>(matrix.rows().data());
  view.x = m.values().data();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

BlockCholesky::BlockCholesky(const BlockMatrix& pattern, FactorKind kind)
    : impl_(std::make_unique<Impl>()) {
  cholmod_common& common = *impl_->context.get();
  KeepOrder(common);
  common.supernodal = kind == FactorKind::kBest ? CHOLMOD_AUTO : CHOLMOD_SUPERNODAL;
  common.final_ll = 1;
  cholmod_sparse view = ViewOf(pattern);
  impl_->factor = FactorPtr(cholmod_analyze(&view, &common), FreeFactor{&common});
  CheckMemory(common);
  impl_->entries = common.lnz;
}

BlockCholesky::~BlockCholesky() = default;
BlockCholesky::BlockCholesky(BlockCholesky&&) noexcept = default;
BlockCholesky& BlockCholesky::operator=(BlockCholesky&&) noexcept = default;

bool BlockCholesky::Factorize(const BlockMatrix& matrix) {
  const BlasGuard guard;
  cholmod_common& common = *impl_->context.get();
  cholmod_sparse view = ViewOf(matrix);
  cholmod_factorize(&view, impl_->factor.get(), &common);
  CheckMemory(common);
  return common.status == CHOLMOD_OK && impl_->factor->minor == impl_->factor->n;
}

Eigen::MatrixXd BlockCholesky::Solve(const Eigen::MatrixXd& right_sides) const {
  const BlasGuard guard;
  cholmod_common& common = *impl_->context.get();
  Eigen::MatrixXd b = right_sides;
  cholmod_dense view = ViewOf(b);
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, impl_->factor.get(), &view, &common);
  CheckMemory(common);
  Eigen::MatrixXd solution =
      Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), b.rows(), b.cols());
  cholmod_free_dense(&x, &common);
  return solution;
}

double BlockCholesky::entries() const { return impl_->entries; }

}  // namespace ariadne::slam
