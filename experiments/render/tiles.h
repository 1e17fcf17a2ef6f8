#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/render/splats.h"

namespace ariadne::experiments {

/// A part of the picture so small that all that is known of its pixels stays in the processor's cache.
struct Tile {
  static constexpr int kSide = 64;  // [px]

  int left = 0;    // first column
  int top = 0;     // first row
  int right = 0;   // one past the last column
  int bottom = 0;  // one past the last row

  /// Where a pixel stands among those of the tile.
  std::size_t IndexOf(int x, int y) const {
    return static_cast<std::size_t>(y - top) * kSide + static_cast<std::size_t>(x - left);
  }
};

/// Which splats touch which tile of a picture, in the order of the splats.
class TileIndex {
 public:
  TileIndex(int width, int height, const std::vector<Splat>& splats);

  std::size_t size() const { return begin_.size() - 1; }
  Tile TileAt(std::size_t i) const;
  std::span<const std::uint32_t> SplatsOf(std::size_t i) const {
    return {indices_.data() + begin_[i], indices_.data() + begin_[i + 1]};
  }

 private:
  template <typename Visit>
  void ForEachTile(const Splat& splat, const Visit& visit) const;

  int width_, height_;              // of the picture [px]
  int columns_, rows_;              // of tiles
  std::vector<std::size_t> begin_;  // of each tile's part of indices_
  std::vector<std::uint32_t> indices_;
};

}  // namespace ariadne::experiments
