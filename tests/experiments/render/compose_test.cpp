#include "experiments/render/compose.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr Rgb kRed{200, 0, 0};
constexpr Rgb kGreen{0, 200, 0};
constexpr Rgb kBlue{0, 0, 200};
constexpr Rgb kGray{128, 128, 128};

TEST(Grid, PutsPicturesSideBySide) {
  const Image row =
      Grid({Image(3, 2, kRed), Image(2, 2, kGreen)}, {.gap = 1, .margin = 2, .background = kGray});
  EXPECT_EQ(row.width, 2 + 3 + 1 + 2 + 2);
  EXPECT_EQ(row.height, 2 + 2 + 2);
  EXPECT_EQ(row.At(1, 2), kGray);
  EXPECT_EQ(row.At(2, 2), kRed);
  EXPECT_EQ(row.At(4, 3), kRed);
  EXPECT_EQ(row.At(5, 3), kGray);
  EXPECT_EQ(row.At(6, 2), kGreen);
  EXPECT_EQ(row.At(6, 4), kGray);
}

TEST(Grid, FillsRowsAndCentersSmallPictures) {
  const Image grid = Grid({Image(4, 4, kRed), Image(2, 2, kGreen), Image(2, 2, kBlue)},
                          {.columns = 2, .gap = 0, .background = kGray});
  EXPECT_EQ(grid.width, 6);
  EXPECT_EQ(grid.height, 6);
  EXPECT_EQ(grid.At(4, 0), kGray);
  EXPECT_EQ(grid.At(4, 1), kGreen);
  EXPECT_EQ(grid.At(0, 4), kGray);
  EXPECT_EQ(grid.At(1, 4), kBlue);
  EXPECT_EQ(grid.At(5, 5), kGray) << "the cell without a picture";
}

TEST(Grid, RefusesNothingAndNegativeGaps) {
  EXPECT_THROW(Grid({}), Error);
  EXPECT_THROW(Grid({Image(1, 1)}, {.gap = -1}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
