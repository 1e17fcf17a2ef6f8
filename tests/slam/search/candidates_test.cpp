// NearestWithMargin, on whose promise the tracker of correspondences relies: no point other than the
// candidates is within others_beyond.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/brute_force.h"
#include "tests/support/difficult_clouds.h"

namespace ariadne::slam {
namespace {

std::vector<std::uint32_t> IndicesOf(const Candidates& candidates) {
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t index : candidates.index) {
    if (index != kNoPoint) indices.push_back(index);
  }
  return indices;
}

/// The radius of the definition, but where more points than candidates are within, that of the first left
/// out.
double RadiusOf(const std::vector<Neighbor>& all, double max_distance, double margin) {
  const double nearest = all.empty() ? max_distance : std::sqrt(all[0].squared_distance);
  const double radius = std::min(nearest, max_distance) + margin;
  if (all.size() <= Candidates::kMax) return radius;
  return std::min(radius, std::sqrt(all[Candidates::kMax].squared_distance));
}

class CandidatesOf : public testing::TestWithParam<NamedCloud> {
 protected:
  /// Calls f(margin, gate, candidates, all points by distance).
  template <typename Function>
  void ForCases(const Function& f) const {
    for (const Eigen::Vector3d& query : QueriesFor(points_)) {
      const std::vector<Neighbor> all = AllByDistance(points_, query);
      for (const double gate : {0.05, 0.25, 0.5, 3.0}) {
        for (const double margin : {0.0, 1e-9, 0.02, 0.25, 1.0}) {
          f(margin, gate, tree_.NearestWithMargin(query, gate, margin), all);
        }
      }
    }
  }

  const std::vector<Eigen::Vector3d>& points_ = GetParam().points;
  const KdTree tree_{points_};
};
INSTANTIATE_TEST_SUITE_P(Clouds, CandidatesOf, testing::ValuesIn(DifficultClouds()), NameForTest);

TEST_P(CandidatesOf, LeaveNoOtherPointWithinTheirRadius) {
  ForCases([](double, double, const Candidates& candidates, const std::vector<Neighbor>& all) {
    const std::vector<std::uint32_t> indices = IndicesOf(candidates);
    for (const Neighbor& neighbor : all) {
      if (std::ranges::count(indices, neighbor.index) > 0) continue;
      EXPECT_GE(std::sqrt(neighbor.squared_distance), candidates.others_beyond);
      break;  // the others are farther
    }
  });
}

TEST_P(CandidatesOf, ReachAsFarAsTheMarginAsksOrTheirNumberAllows) {
  ForCases([](double margin, double gate, const Candidates& candidates, const std::vector<Neighbor>& all) {
    const double radius = RadiusOf(all, gate, margin);
    EXPECT_NEAR(candidates.others_beyond, radius, 1e-12 * radius);
  });
}

TEST_P(CandidatesOf, BeginWithTheNearestInOrder) {
  ForCases([](double margin, double gate, const Candidates& candidates, const std::vector<Neighbor>& all) {
    const std::vector<std::uint32_t> indices = IndicesOf(candidates);
    const double radius = RadiusOf(all, gate, margin) * (1.0 - 1e-12);
    for (std::size_t i = 0; i < Candidates::kMax && i < all.size(); ++i) {
      if (std::sqrt(all[i].squared_distance) >= radius) break;
      ASSERT_LT(i, indices.size());
      EXPECT_EQ(indices[i], all[i].index);
    }
  });
}

TEST(Candidates, AreNoneWhereNothingIsNear) {
  const Candidates candidates = KdTree({{1.0, 0.0, 0.0}}).NearestWithMargin({3.0, 0.0, 0.0}, 0.5, 0.1);
  EXPECT_TRUE(IndicesOf(candidates).empty());
  EXPECT_DOUBLE_EQ(candidates.others_beyond, 0.6);
}

}  // namespace
}  // namespace ariadne::slam
