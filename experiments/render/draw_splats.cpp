#include "experiments/render/draw_splats.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "experiments/render/tiles.h"

namespace ariadne::experiments {
namespace {

constexpr float kSurfaceDepth = 4.0F;  // of what blends, behind the nearest disc, per grain of a disc
constexpr float kRimShare = 0.01F;     // weight at the rim of a disc: not 0, because it may be alone there

/// Sums over the discs of the nearest surface in a pixel: weight, and weighted red, green, blue, depth [m]
/// and grain [m]. Two places are free, because eight floats are added at once.
using Blend = Eigen::Array<float, 8, 1>;

template <typename T>
using PerPixel = std::array<T, std::size_t{Tile::kSide} * Tile::kSide>;

/// Calls visit(y, first, last, dy) for each row of the tile that the disc covers from column `first` to
/// `last`; dy is the distance of the row from the disc's centre.
template <typename Visit>
void ForEachRow(const Splat& splat, const Tile& tile, const Visit& visit) {
  const float u = splat.u - 0.5F;  // in units where pixel centres are whole
  const float v = splat.v - 0.5F;
  const int top = std::max(tile.top, static_cast<int>(std::ceil(v - splat.radius)));
  const int bottom = std::min(tile.bottom - 1, static_cast<int>(std::floor(v + splat.radius)));
  for (int y = top; y <= bottom; ++y) {
    const float dy = static_cast<float>(y) - v;
    const float half_width = std::sqrt(std::max(0.0F, splat.radius * splat.radius - dy * dy));
    const int first = std::max(tile.left, static_cast<int>(std::ceil(u - half_width)));
    const int last = std::min(tile.right - 1, static_cast<int>(std::floor(u + half_width)));
    if (first <= last) visit(y, first, last, dy);
  }
}

/// Draws the discs of one tile after the other; holds what is needed for one.
class TilePainter {
 public:
  explicit TilePainter(Frame& frame) : frame_(frame) {}

  void Paint(const Tile& tile, const std::vector<Splat>& splats, std::span<const std::uint32_t> indices) {
    if (indices.empty()) return;
    Load(tile);
    for (const std::uint32_t i : indices) FindNearest(tile, splats[i]);
    blends_.fill(Blend::Zero());
    for (const std::uint32_t i : indices) AddToBlend(tile, splats[i]);
    Store(tile);
  }

 private:
  void Load(const Tile& tile) {
    for (int y = tile.top; y < tile.bottom; ++y) {
      std::copy_n(&frame_.depth[frame_.color.IndexOf(tile.left, y)], tile.right - tile.left,
                  &nearest_[tile.IndexOf(tile.left, y)]);
    }
  }

  void FindNearest(const Tile& tile, const Splat& splat) {
    ForEachRow(splat, tile, [&](int y, int first, int last, float) {
      float* nearest = &nearest_[tile.IndexOf(first, y)];
      for (int i = 0; i <= last - first; ++i) nearest[i] = std::min(nearest[i], splat.depth);
    });
  }

  void AddToBlend(const Tile& tile, const Splat& splat) {
    const float front = splat.depth - kSurfaceDepth * splat.grain;
    const float per_radius2 = 1.0F / (splat.radius * splat.radius);
    Blend values;
    values << 1.0F, splat.color.r, splat.color.g, splat.color.b, splat.depth, splat.grain, 0.0F, 0.0F;
    ForEachRow(splat, tile, [&](int y, int first, int last, float dy) {
      std::size_t pixel = tile.IndexOf(first, y);
      for (int x = first; x <= last; ++x, ++pixel) {
        if (front > nearest_[pixel]) continue;
        const float dx = static_cast<float>(x) + 0.5F - splat.u;
        const float share = 1.0F - (dx * dx + dy * dy) * per_radius2;  // 1 in the centre, 0 at the rim
        blends_[pixel] += (std::max(share, 0.0F) + kRimShare) * values;
      }
    });
  }

  void Store(const Tile& tile) {
    for (int y = tile.top; y < tile.bottom; ++y) {
      for (int x = tile.left; x < tile.right; ++x) {
        const std::size_t to = frame_.color.IndexOf(x, y);
        const bool is_hidden = !(nearest_[tile.IndexOf(x, y)] < frame_.depth[to]);
        if (is_hidden) continue;
        const Blend& sums = blends_[tile.IndexOf(x, y)];
        const Blend mean = sums / sums[0];
        frame_.color.pixels[to] = {ToChannel(mean[1]), ToChannel(mean[2]), ToChannel(mean[3])};
        frame_.depth[to] = mean[4];
        frame_.grain[to] = mean[5];
      }
    }
  }

  Frame& frame_;
  PerPixel<float> nearest_;  // depth of the nearest disc, or of what the frame holds [m]
  PerPixel<Blend> blends_;
};

}  // namespace

void DrawSplats(Frame& frame, const std::vector<Splat>& splats) {
  const TileIndex tiles(frame.color.width, frame.color.height, splats);
  TilePainter painter(frame);
  for (std::size_t i = 0; i < tiles.size(); ++i) painter.Paint(tiles.TileAt(i), splats, tiles.SplatsOf(i));
}

}  // namespace ariadne::experiments
