#include "slam/sparse/selected_inverse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <span>

#include "slam/base/error.h"
#include "slam/sparse/block_cholesky_impl.h"

namespace ariadne::slam {
namespace {

using Map = Eigen::Map<const Eigen::MatrixXd>;

/// CHOLMOD's supernodal factor: supernode s has the columns [first_column(s), first_column(s + 1)), and the
/// rows rows(s), the first of which are its own columns; its values are a dense matrix of rows x columns.
struct Supernodes {
  const cholmod_factor& factor;

  Eigen::Index count() const { return static_cast<Eigen::Index>(factor.nsuper); }
  Eigen::Index first_column(Eigen::Index s) const { return static_cast<const int*>(factor.super)[s]; }
  Eigen::Index columns(Eigen::Index s) const { return first_column(s + 1) - first_column(s); }
  std::span<const int> rows(Eigen::Index s) const {
    const int* begins = static_cast<const int*>(factor.pi);
    return {static_cast<const int*>(factor.s) + begins[s],
            static_cast<const int*>(factor.s) + begins[s + 1]};
  }
  Map values(Eigen::Index s) const {
    const double* begin = static_cast<const double*>(factor.x) + static_cast<const int*>(factor.px)[s];
    return {begin, static_cast<Eigen::Index>(rows(s).size()), columns(s)};
  }
};

class Recursion {
 public:
  explicit Recursion(const cholmod_factor& factor)
      : nodes_{factor}, supernode_of_(static_cast<std::size_t>(factor.n)) {
    for (Eigen::Index s = 0; s < nodes_.count(); ++s) {
      for (Eigen::Index c = nodes_.first_column(s); c < nodes_.first_column(s + 1); ++c)
        supernode_of_[static_cast<std::size_t>(c)] = s;
    }
    inverse_.resize(static_cast<std::size_t>(nodes_.count()));
    // Backwards, as each panel needs those of the columns that its rows stand for.
    for (Eigen::Index s = nodes_.count() - 1; s >= 0; --s) inverse_[static_cast<std::size_t>(s)] = Panel(s);
  }

  /// An entry of the inverse, row >= column, where the factor has one.
  double Entry(Eigen::Index row, Eigen::Index column) const {
    const Eigen::Index s = supernode_of_[static_cast<std::size_t>(column)];
    const auto rows = nodes_.rows(s);
    const auto place = std::lower_bound(rows.begin(), rows.end(), static_cast<int>(row)) - rows.begin();
    return inverse_[static_cast<std::size_t>(s)](place, column - nodes_.first_column(s));
  }

 private:
  /// The inverse at the rows and columns of a supernode: with the factor's panel [D; B] and what lies
  /// below, Z_below,own = -Z_below,below B D^-1 and Z_own,own = D^-T D^-1 - (B D^-1)^T Z_below,own.
  Eigen::MatrixXd Panel(Eigen::Index s) const {
    const Map values = nodes_.values(s);
    const Eigen::Index own = nodes_.columns(s), below = values.rows() - own;
    const auto D = values.topRows(own).triangularView<Eigen::Lower>();
    Eigen::MatrixXd panel(values.rows(), own);
    const Eigen::MatrixXd D_inverse = D.solve(Eigen::MatrixXd::Identity(own, own));
    panel.topRows(own) = D_inverse.transpose() * D_inverse;
    if (below == 0) return panel;
    const Eigen::MatrixXd BD = values.bottomRows(below) * D_inverse;
    panel.bottomRows(below).noalias() = -Gather(nodes_.rows(s).subspan(static_cast<std::size_t>(own))) * BD;
    panel.topRows(own).noalias() -= BD.transpose() * panel.bottomRows(below);
    return panel;
  }

  /// The inverse at all pairs of these rows, all of which the factor has.
  Eigen::MatrixXd Gather(std::span<const int> rows) const {
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd gathered(count, count);
    for (Eigen::Index c = 0; c < count; ++c) {
      const Eigen::Index column = rows[static_cast<std::size_t>(c)];
      const Eigen::Index s = supernode_of_[static_cast<std::size_t>(column)];
      const auto of_s = nodes_.rows(s);
      const auto panel = inverse_[static_cast<std::size_t>(s)].col(column - nodes_.first_column(s));
      auto place = of_s.begin();
      for (Eigen::Index r = c; r < count; ++r) {
        place = std::lower_bound(place, of_s.end(), rows[static_cast<std::size_t>(r)]);
        gathered(r, c) = gathered(c, r) = panel[place - of_s.begin()];
      }
    }
    return gathered;
  }

  Supernodes nodes_;
  std::vector<Eigen::Index> supernode_of_;  // per column
  std::vector<Eigen::MatrixXd> inverse_;    // per supernode: its panel of the inverse
};

}  // namespace

std::vector<Eigen::MatrixXd> DiagonalBlocksOfInverse(const BlockCholesky& factor,
                                                     const BlockMatrix& pattern) {
  const cholmod_factor& L = *factor.impl_->factor;
  if (L.is_super == 0) Fail("the selected inverse needs a supernodal factor");
  const Recursion recursion(L);
  std::vector<Eigen::MatrixXd> blocks;
  const Eigen::Index size = pattern.block_size();
  for (std::size_t i = 0; i < pattern.blocks(); ++i) {
    Eigen::MatrixXd block(size, size);
    for (Eigen::Index c = 0; c < size; ++c) {
      for (Eigen::Index r = c; r < size; ++r)
        block(r, c) = block(c, r) = recursion.Entry(pattern.row(i) + r, pattern.row(i) + c);
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace ariadne::slam
