#include "experiments/report/graph_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ariadne::experiments {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

constexpr Rgb kRed{214, 64, 40};  // of rejected closures

/// Pixels in which red dominates clearly.
std::ptrdiff_t RedPixels(const Image& image) {
  return std::ranges::count_if(image.pixels, [](Rgb p) { return p.r > p.b + 40 && p.r > p.g + 40; });
}

DrawnGraph Square(bool planar, double weight) {
  return {{{0, 1}, {1, 2}, {2, 3}, {3, 0, true, 1.0}, {0, 2, true, weight}}, planar};
}

const Positions kCorners{{0, 0, 0}, {4, 0, 0}, {4, 3, 1}, {0, 3, 1}};

TEST(GraphPicture, ShowsRejectedClosuresInRed) {
  for (const bool planar : {true, false}) {
    const Image kept = GraphPicture(Square(planar, 1.0), kCorners, kCorners, "a", "b");
    const Image rejected = GraphPicture(Square(planar, 0.0), kCorners, kCorners, "a", "b");
    EXPECT_EQ(RedPixels(kept), 0);
    EXPECT_GT(RedPixels(rejected), 100);
    EXPECT_NE(std::ranges::find(rejected.pixels, kRed), rejected.pixels.end()) << "in the legend";
  }
}

TEST(GraphPicture, IsTheSameForTheSameGraph) {
  EXPECT_EQ(GraphPicture(Square(false, 1.0), kCorners, kCorners, "a", "b"),
            GraphPicture(Square(false, 1.0), kCorners, kCorners, "a", "b"));
}

TEST(GraphPicture, StandsPosesThatAreOnePoint) {
  const Positions point(4, Eigen::Vector3d(1, 2, 3));
  EXPECT_NO_THROW(GraphPicture(Square(true, 1.0), point, kCorners, "a", "b"));
  EXPECT_NO_THROW(GraphPicture(Square(false, 1.0), kCorners, point, "a", "b"));
}

}  // namespace
}  // namespace ariadne::experiments
