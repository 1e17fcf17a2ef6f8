#include "slam/geometry/box3.h"

#include <gtest/gtest.h>

namespace ariadne::slam {
namespace {

TEST(BoxAround, IsEmptyWithoutPoints) { EXPECT_TRUE(BoxAround({}).isEmpty()); }

TEST(BoxAround, HoldsASinglePointOfNegativeCoordinates) {
  const Eigen::Vector3d p(-1.0, -2.0, -3.0);
  const Box3 box = BoxAround({p});
  EXPECT_FALSE(box.isEmpty());
  EXPECT_EQ(box.min(), p);
  EXPECT_EQ(box.max(), p);
}

TEST(BoxAround, IsTheSmallestAroundThePoints) {
  const Box3 box = BoxAround({{1.0, -5.0, 2.0}, {3.0, 4.0, -1.0}, {2.0, 0.0, 9.0}});
  EXPECT_EQ(box.min(), Eigen::Vector3d(1.0, -5.0, -1.0));
  EXPECT_EQ(box.max(), Eigen::Vector3d(3.0, 4.0, 9.0));
  EXPECT_TRUE(box.contains(Eigen::Vector3d(3.0, -5.0, 9.0))) << "corners are inside";
  EXPECT_FALSE(box.contains(Eigen::Vector3d(3.1, 0.0, 0.0)));
}

TEST(Box3, KnowsItsDistanceFromAPointOutside) {
  const Box3 box = BoxAround({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
  EXPECT_DOUBLE_EQ(box.exteriorDistance(Eigen::Vector3d(4.0, 5.0, 0.5)), 5.0);
  EXPECT_DOUBLE_EQ(box.exteriorDistance(Eigen::Vector3d(0.5, 0.5, 0.5)), 0.0);
}

}  // namespace
}  // namespace ariadne::slam
