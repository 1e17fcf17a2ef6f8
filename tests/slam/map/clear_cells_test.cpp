#include "slam/map/clear_cells.h"

#include <gtest/gtest.h>

#include "slam/base/random.h"

namespace ariadne::slam {
namespace {

constexpr Layers kAll = ~Layers{0};

TEST(ClearCells, AreThoseWithoutAGap) {
  const std::array<Layers, 4> passed{kAll, kAll << 3, kAll << 4, 0};
  EXPECT_EQ(ClearCells(passed, 4, 0, 4), (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(ClearCells(passed, 4, 0, 64), (std::vector<bool>{true, true, true, false}));
}

TEST(ClearCells, CountBeamsBesideThem) {
  const std::array<Layers, 6> passed{kAll, 0, 0, 0, 0, 0};
  EXPECT_EQ(ClearCells(passed, 3, 1, 1), (std::vector<bool>{true, true, false, true, true, false}));
}

/// Layer by layer, and cell by cell.
bool HasGapSlowly(std::span<const Layers> passed, std::size_t columns, std::size_t cell, int around,
                  int gap) {
  const int rows = static_cast<int>(passed.size() / columns), width = static_cast<int>(columns);
  const int row = static_cast<int>(cell) / width, column = static_cast<int>(cell) % width;
  int length = 0;
  for (int layer = 0; layer < 64; ++layer) {
    bool went_through = false;
    for (int r = std::max(0, row - around); r <= std::min(rows - 1, row + around); ++r) {
      for (int c = std::max(0, column - around); c <= std::min(width - 1, column + around); ++c)
        went_through |= (passed[static_cast<std::size_t>(r * width + c)] >> layer & 1) != 0;
    }
    length = went_through ? 0 : length + 1;
    if (length >= gap) return true;
  }
  return false;
}

TEST(ClearCells, AreWhatASlowSearchFinds) {
  RandomStream stream = NamedStream(1, "cells");
  std::size_t clear_count = 0, count = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t columns = 1 + static_cast<std::size_t>(trial % 7);
    std::vector<Layers> passed(columns * (1 + static_cast<std::size_t>(trial % 5)));
    for (Layers& layers : passed) {
      const Layers some = stream();
      const Layers others = stream();
      layers = some | others;
    }
    const int around = trial % 3, gap = 1 + trial % 6;
    const std::vector<bool> clear = ClearCells(passed, columns, around, gap);
    for (std::size_t i = 0; i < passed.size(); ++i)
      ASSERT_EQ(clear[i], !HasGapSlowly(passed, columns, i, around, gap)) << trial << " " << i;
    clear_count += static_cast<std::size_t>(std::ranges::count(clear, true));
    count += clear.size();
  }
  EXPECT_GT(clear_count, count / 5);
  EXPECT_LT(clear_count, count * 4 / 5);
}

}  // namespace
}  // namespace ariadne::slam
