#include "experiments/render/compose.h"

#include <algorithm>
#include <numeric>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// The length of cells in a row with gaps between and margins around.
int TotalLength(const std::vector<int>& cells, const GridOptions& options) {
  return std::accumulate(cells.begin(), cells.end(), 0) +
         options.gap * (static_cast<int>(cells.size()) - 1) + 2 * options.margin;
}

}  // namespace

Image Grid(const std::vector<Image>& parts, const GridOptions& options) {
  if (parts.empty()) Fail("a grid of pictures needs at least one picture");
  if (options.gap < 0 || options.margin < 0) Fail("gap and margin of a grid must not be negative");
  const std::size_t columns =
      options.columns > 0 ? static_cast<std::size_t>(options.columns) : parts.size();
  std::vector<int> widths(std::min(columns, parts.size()), 0);
  std::vector<int> heights((parts.size() + columns - 1) / columns, 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    widths[i % columns] = std::max(widths[i % columns], parts[i].width);
    heights[i / columns] = std::max(heights[i / columns], parts[i].height);
  }

  Image grid(TotalLength(widths, options), TotalLength(heights, options), options.background);
  int top = options.margin;
  for (std::size_t row = 0; row < heights.size(); ++row) {
    int left = options.margin;
    for (std::size_t column = 0; column < widths.size() && row * columns + column < parts.size();
         ++column) {
      const Image& part = parts[row * columns + column];
      Paste(grid, part, left + (widths[column] - part.width) / 2, top + (heights[row] - part.height) / 2);
      left += widths[column] + options.gap;
    }
    top += heights[row] + options.gap;
  }
  return grid;
}

}  // namespace ariadne::experiments
