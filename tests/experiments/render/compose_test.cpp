#include "experiments/render/compose.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"
#include "tests/experiments/render/colors.h"

namespace ariadne::experiments {
namespace {

TEST(Grid, PutsPicturesSideBySide) {
  const Image row =
      Grid({Image(3, 2, kRed), Image(2, 2, kGreen)}, {.gap = 1, .margin = 2, .background = kMidGray});
  EXPECT_EQ(row.width, 2 + 3 + 1 + 2 + 2);
  EXPECT_EQ(row.height, 2 + 2 + 2);
  EXPECT_EQ(row.At(1, 2), kMidGray);
  EXPECT_EQ(row.At(2, 2), kRed);
  EXPECT_EQ(row.At(4, 3), kRed);
  EXPECT_EQ(row.At(5, 3), kMidGray);
  EXPECT_EQ(row.At(6, 2), kGreen);
  EXPECT_EQ(row.At(6, 4), kMidGray);
}

TEST(Grid, FillsRowsAndCentersSmallPictures) {
  const Image grid = Grid({Image(4, 4, kRed), Image(2, 2, kGreen), Image(2, 2, kBlue)},
                          {.columns = 2, .gap = 0, .background = kMidGray});
  EXPECT_EQ(grid.width, 6);
  EXPECT_EQ(grid.height, 6);
  EXPECT_EQ(grid.At(4, 0), kMidGray);
  EXPECT_EQ(grid.At(4, 1), kGreen);
  EXPECT_EQ(grid.At(0, 4), kMidGray);
  EXPECT_EQ(grid.At(1, 4), kBlue);
  EXPECT_EQ(grid.At(5, 5), kMidGray) << "the cell without a picture";
}

TEST(Grid, RefusesNothingAndNegativeGaps) {
  EXPECT_THROW(Grid({}), Error);
  EXPECT_THROW(Grid({Image(1, 1)}, {.gap = -1}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
