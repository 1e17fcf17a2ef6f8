#include "slam/search/kd_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/brute_force.h"
#include "tests/support/difficult_clouds.h"

namespace ariadne::slam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MATCHER_P(SameNeighbor, expected, "") {
  *result_listener << "index " << arg.index << " at " << arg.squared_distance << ", expected "
                   << expected.index << " at " << expected.squared_distance;
  if (arg.index != expected.index) return false;
  return arg.index == kNoPoint || arg.squared_distance == expected.squared_distance;  // to the last bit
}

class KdTreeOf : public testing::TestWithParam<NamedCloud> {
 protected:
  const std::vector<Eigen::Vector3d>& points_ = GetParam().points;
  const KdTree tree_{points_};
  const std::vector<Eigen::Vector3d> queries_ = QueriesFor(points_);
};
INSTANTIATE_TEST_SUITE_P(Clouds, KdTreeOf, testing::ValuesIn(DifficultClouds()), NameForTest);

TEST_P(KdTreeOf, FindsTheNearestAndOfTiesTheLowestIndex) {
  for (const Eigen::Vector3d& query : queries_) {
    for (const double gate : {kInfinity, 1.0, 0.25, 0.1, 0.0}) {
      EXPECT_THAT(tree_.Nearest(query, gate), SameNeighbor(NearestOfAll(points_, query, gate)))
          << "gate " << gate << ", query " << query.transpose();
    }
  }
}

TEST_P(KdTreeOf, CountsOnlyPointsThatAreStrictlyCloserThanTheGate) {
  for (const Eigen::Vector3d& query : queries_) {
    const Neighbor nearest = NearestOfAll(points_, query, kInfinity);
    if (nearest.index == kNoPoint) continue;
    // The gate is compared squared, so it is hit exactly where its square is the squared distance.
    const double gate = std::sqrt(nearest.squared_distance);
    if (gate * gate == nearest.squared_distance) {
      EXPECT_EQ(tree_.Nearest(query, gate).index, kNoPoint);
    }
    EXPECT_THAT(tree_.Nearest(query, gate * (1.0 + 1e-15) + 1e-150), SameNeighbor(nearest));
  }
}

TEST_P(KdTreeOf, FindsTheKNearestInOrder) {
  for (const Eigen::Vector3d& query : queries_) {
    const std::vector<Neighbor> all = AllByDistance(points_, query);
    for (const std::size_t k : {1u, 2u, 7u, 64u, 1000u}) {
      std::vector<Neighbor> nearest(k);
      ASSERT_EQ(tree_.NearestK(query, nearest), std::min(k, points_.size()));
      for (std::size_t i = 0; i < std::min(k, all.size()); ++i) {
        EXPECT_THAT(nearest[i], SameNeighbor(all[i])) << i << " of " << k;
      }
    }
  }
}

TEST_P(KdTreeOf, KeepsThePointsInTheirOrder) { EXPECT_EQ(tree_.points(), points_); }

TEST(KdTree, TakesTheGateExactly) {
  const KdTree tree({{0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {-1.0, 0.0, 0.0}});
  EXPECT_EQ(tree.Nearest(Eigen::Vector3d::Zero(), 0.5).index, kNoPoint);
  EXPECT_EQ(tree.Nearest(Eigen::Vector3d::Zero(), std::nextafter(0.5, 1.0)).index, 0u);
}

TEST(KdTree, FillsNothingWhereNothingIsAskedFor) {
  EXPECT_EQ(KdTree({{1.0, 2.0, 3.0}}).NearestK(Eigen::Vector3d::Zero(), {}), 0u);
}

TEST(KdTree, SearchesAfterAMove) {
  KdTree first({{1.0, 0.0, 0.0}});
  KdTree second({{2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}});
  first = std::move(second);
  const KdTree third = std::move(first);
  EXPECT_EQ(third.Nearest({2.9, 0.0, 0.0}, 1.0).index, 1u);
}

}  // namespace
}  // namespace ariadne::slam
