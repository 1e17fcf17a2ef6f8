#include <vector>

#include "slam/base/error.h"
#include "slam/sparse/block_matrix.h"
#include "slam/sparse/cholmod.h"

namespace ariadne::slam {

BlockOrder OrderBlocks(std::size_t blocks, const std::vector<BlockPlace>& places) {
  BlockOrder natural(blocks);
  for (std::size_t i = 0; i < blocks; ++i) natural[i] = static_cast<std::int32_t>(i);
  const BlockMatrix pattern(1, natural, places);

  CholmodContext context;
  cholmod_common& common = *context.get();
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_AMD;
  common.supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_sparse view{};
  view.nrow = view.ncol = blocks;
  view.nzmax = pattern.rows().size();
  view.p = const_cast<std::int32_t*>(pattern.column_begins().data());
  view.i = const_cast<std::int32_t*>(pattern.rows().data());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_PATTERN;
  view.sorted = 1;
  view.packed = 1;
  const FactorPtr factor(cholmod_analyze(&view, &common), FreeFactor{&common});
  if (!factor) Fail("CHOLMOD could not order {} blocks (status {})", blocks, common.status);
  BlockOrder order(blocks);
  const auto* block_at = static_cast<const std::int32_t*>(factor->Perm);
  for (std::size_t k = 0; k < blocks; ++k)
    order[static_cast<std::size_t>(block_at[k])] = static_cast<std::int32_t>(k);
  return order;
}

}  // namespace ariadne::slam
