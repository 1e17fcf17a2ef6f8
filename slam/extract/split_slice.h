#pragma once

#include <span>
#include <vector>

#include "slam/extract/split_and_merge.h"

namespace ariadne::slam {

/// Consecutive points of a slice.
struct Piece {
  std::size_t first = 0;
  std::size_t last = 0;  // included

  std::size_t size() const { return last - first + 1; }
};

/// Whether the surface ends between two points: one that is met at the grazing angle would, by the law of
/// sines, put them no farther apart than this.
bool IsGap(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const SplitAndMergeOptions& options);

/// The slice, cut at gaps and where a piece leaves the chord of its ends by more than the noise explains.
std::vector<Piece> SplitSlice(std::span<const Eigen::Vector2d> points, const SplitAndMergeOptions& options);

}  // namespace ariadne::slam
