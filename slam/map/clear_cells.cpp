#include "slam/map/clear_cells.h"

#include <algorithm>

namespace ariadne::slam {
namespace {

/// Each layer with those of up to `around` places before and behind it on a line.
void SpreadLine(Layers* first, std::size_t count, std::size_t stride, std::size_t around,
                std::vector<Layers>& before) {
  before.resize(count);
  for (std::size_t i = 0; i < count; ++i) before[i] = first[i * stride];
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t last = std::min(count - 1, i + around);
    Layers all = 0;
    for (std::size_t k = i - std::min(i, around); k <= last; ++k) all |= before[k];
    first[i * stride] = all;
  }
}

/// Whether so many layers, one above the other, are not among these.
bool HasGap(Layers layers, int gap) {
  Layers from = ~layers;  // where a gap of `length` layers begins
  for (int length = 1; length < gap;) {
    const int more = std::min(length, gap - length);
    from &= from >> more;
    length += more;
  }
  return from != 0;
}

}  // namespace

std::vector<bool> ClearCells(std::span<const Layers> passed, std::size_t columns, int around, int gap) {
  std::vector<Layers> layers(passed.begin(), passed.end());
  if (layers.empty()) return {};
  const std::size_t rows = layers.size() / columns;
  const auto reach = static_cast<std::size_t>(std::max(0, around));
  std::vector<Layers> line;
  for (std::size_t r = 0; r < rows; ++r) SpreadLine(&layers[r * columns], columns, 1, reach, line);
  for (std::size_t c = 0; c < columns; ++c) SpreadLine(&layers[c], rows, columns, reach, line);
  std::vector<bool> clear(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) clear[i] = !HasGap(layers[i], gap);
  return clear;
}

}  // namespace ariadne::slam
