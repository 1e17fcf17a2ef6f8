#include "experiments/render/column_ink.h"

#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

/// Columns of 0.1 m are 10 px wide here.
Camera Top() { return TopView({100, 50}, Up::kPlusY, {0, 0, 0}, 100.0); }

/// `count` points from top to bottom of a column, over 3 m for a wall and over nothing for a floor.
std::vector<ImagePoint> Column(double u, double height, int count) {
  std::vector<ImagePoint> points;
  for (int i = 0; i < count; ++i) points.push_back({u, 5.0, 3.0 - height * i / (count - 1)});
  return points;
}

/// All ink of a column at u = 15 beside a wall that gives the layers their range.
float InkOf(const std::vector<ImagePoint>& column) {
  std::vector<ImagePoint> points = Column(55.0, 3.0, 1000);
  points.insert(points.end(), column.begin(), column.end());
  const std::vector<float> ink = ColumnInk(points, Top(), 0.1);
  float sum = 0.0F;
  for (std::size_t i = 1000; i < ink.size(); ++i) sum += ink[i];
  return sum;
}

TEST(ColumnInk, DoesNotDependOnHowOftenAWallWasHit) {
  const float often = InkOf(Column(15.0, 3.0, 1000));
  EXPECT_NEAR(InkOf(Column(15.0, 3.0, 100)), often, 0.001F * often);
  EXPECT_GT(often, 20.0F);
}

TEST(ColumnInk, GrowsWithTheHeight) {
  const float high = InkOf(Column(15.0, 3.0, 500));
  EXPECT_NEAR(InkOf(Column(15.0, 1.5, 500)) / high, 0.5, 0.1);
  EXPECT_LT(InkOf(Column(15.0, 0.0, 500)), 0.05F * high) << "a floor";
}

TEST(ColumnInk, IsNoneOutsideOfThePicture) {
  EXPECT_EQ(ColumnInk({{-1.0, 5.0, 0.0}, {5.0, 50.0, 0.0}, {1e30, 5.0, 0.0}}, Top(), 0.1),
            (std::vector<float>{0.0F, 0.0F, 0.0F}));
  EXPECT_TRUE(ColumnInk({}, Top(), 0.1).empty());
}

}  // namespace
}  // namespace ariadne::experiments
