#include "experiments/render/tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ariadne::experiments {

TileIndex::TileIndex(int width, int height, const std::vector<Splat>& splats)
    : width_(width),
      height_(height),
      columns_((width + Tile::kSide - 1) / Tile::kSide),
      rows_((height + Tile::kSide - 1) / Tile::kSide),
      begin_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0) {
  // Counting sort: the size of each tile's part, then where it begins, then who is in it.
  for (const Splat& splat : splats) ForEachTile(splat, [&](std::size_t tile) { ++begin_[tile + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  indices_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < splats.size(); ++i) {
    ForEachTile(splats[i],
                [&](std::size_t tile) { indices_[next[tile]++] = static_cast<std::uint32_t>(i); });
  }
}

Tile TileIndex::TileAt(std::size_t i) const {
  const int left = static_cast<int>(i % static_cast<std::size_t>(columns_)) * Tile::kSide;
  const int top = static_cast<int>(i / static_cast<std::size_t>(columns_)) * Tile::kSide;
  return {left, top, std::min(width_, left + Tile::kSide), std::min(height_, top + Tile::kSide)};
}

template <typename Visit>
void TileIndex::ForEachTile(const Splat& splat, const Visit& visit) const {
  const auto tile_of = [](float pixel, int tiles) {
    return std::clamp(static_cast<int>(std::floor(pixel)) / Tile::kSide, 0, tiles - 1);
  };
  const int last_column = tile_of(splat.u + splat.radius, columns_);
  const int last_row = tile_of(splat.v + splat.radius, rows_);
  for (int row = tile_of(splat.v - splat.radius, rows_); row <= last_row; ++row) {
    for (int column = tile_of(splat.u - splat.radius, columns_); column <= last_column; ++column) {
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column));
    }
  }
}

}  // namespace ariadne::experiments
