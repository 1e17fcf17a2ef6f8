#include "slam/registration/correspondence_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/slam/registration/same_correspondences.h"
#include "tests/support/difficult_clouds.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

struct Step {
  Pose3 T_model_data;
  double max_distance;
};

/// A walk whose steps are large, small, tiny and none, forth and back again, with a gate that shrinks,
/// grows and stays.
std::vector<Step> RandomWalk(int steps, double longest, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "correspondence_tracker_test/walk");
  std::vector<Step> walk = {{Pose3(), 0.5}};
  while (static_cast<int>(walk.size()) < steps) {
    Step step = walk.back();
    const double length = longest * std::pow(10.0, -DrawUniform(stream, 0.0, 9.0));
    const double kind = DrawUniform(stream, 0.0, 1.0);
    if (kind < 0.7) {
      step.T_model_data = DrawMotion(stream, length, length) * step.T_model_data;
    } else if (kind < 0.8) {
      step.T_model_data = walk[walk.size() / 2].T_model_data;
    }
    if (DrawUniform(stream, 0.0, 1.0) < 0.2) step.max_distance *= DrawUniform(stream, 0.6, 1.5);
    walk.push_back(step);
  }
  return walk;
}

/// Follows the walk with trackers of one and two threads, and compares each step with fresh searches.
void ExpectExactAlong(const std::vector<Step>& walk, const std::vector<Eigen::Vector3d>& model,
                      const std::vector<Eigen::Vector3d>& data) {
  const KdTree tree(model);
  CorrespondenceTracker tracker(tree, data), tracker_2(tree, data);
  const Parallel serial(1), two_threads(2);
  for (std::size_t k = 0; k < walk.size(); ++k) {
    const auto& [T, gate] = walk[k];
    const Correspondences expected = FindByKdTree(tree, data, T, gate, serial);
    ASSERT_THAT(tracker.Update(T, gate, serial), SameCorrespondences(expected)) << "step " << k;
    ASSERT_THAT(tracker_2.Update(T, gate, two_threads), SameCorrespondences(expected)) << "step " << k;
    if (k % 10 == 0) {
      ASSERT_THAT(FindByBruteForce(model, data, T, gate, serial), SameCorrespondences(expected));
    }
  }
  EXPECT_EQ(tracker.searches(), tracker_2.searches());
}

class TrackerIn : public testing::TestWithParam<NamedCloud> {};
INSTANTIATE_TEST_SUITE_P(Clouds, TrackerIn, testing::ValuesIn(DifficultClouds()), NameForTest);

TEST_P(TrackerIn, IsExactAlongRandomWalks) {
  for (const double longest : {0.3, 0.01, 1e-6}) {
    ExpectExactAlong(RandomWalk(100, longest, 1), GetParam().points, QueriesFor(GetParam().points));
  }
}

TEST_P(TrackerIn, IsExactOnTheModelItself) {
  ExpectExactAlong(RandomWalk(60, 0.05, 2), GetParam().points, GetParam().points);
}

TEST(CorrespondenceTracker, IsExactWhenALatticeMovesFromTieToTie) {
  const auto lattice = ShuffledLattice(8, 0.25, Eigen::Vector3d::Zero(), 2);
  std::vector<Step> walk;
  for (int i = 0; i <= 16; ++i) {
    const Eigen::Vector3d offset = 0.125 * i * Eigen::Vector3d(1.0, i % 2, i % 3 == 0);
    walk.push_back({Pose3{Eigen::Quaterniond::Identity(), offset}, 0.25});
  }
  ExpectExactAlong(walk, lattice, lattice);
}

TEST(CorrespondenceTracker, IsExactWhereThePoseIsFarFromTheOrigin) {
  const TwoClouds clouds = DrawTwoClouds(1, {.points = 800});
  const Pose3 far{ExpSo3({0.1, 0.2, 0.3}), {1e5, -2e5, 1e5}};
  std::vector<Step> walk = RandomWalk(60, 0.05, 3);
  for (Step& step : walk) step.T_model_data = far * step.T_model_data * clouds.T_model_data;
  ExpectExactAlong(walk, Transformed(far, clouds.model).positions, clouds.data.positions);
}

/// The poses of an alignment: each comes nearer to the last one by a constant factor.
std::vector<Step> ConvergingWalk(const TwoClouds& clouds, int steps, double factor) {
  std::vector<Step> walk;
  double rest = 1.0;
  for (int i = 0; i < steps; ++i, rest *= factor) {
    walk.push_back({Interpolate(clouds.T_model_data, clouds.T_model_data_guess, rest), 0.5});
  }
  return walk;
}

TEST(CorrespondenceTracker, SearchesLittleWhileThePoseConverges) {
  const TwoClouds clouds = DrawTwoClouds(1, {.points = 3000, .start_translation = 0.3, .start_angle = 5.0});
  const KdTree tree(clouds.model.positions);
  const std::vector<Step> walk = ConvergingWalk(clouds, 40, 0.7);
  ExpectExactAlong(walk, clouds.model.positions, clouds.data.positions);
  CorrespondenceTracker tracker(tree, clouds.data.positions);
  for (const Step& step : walk) tracker.Update(step.T_model_data, step.max_distance, Parallel(1));
  EXPECT_GE(tracker.searches(), clouds.data.size());
  EXPECT_LT(tracker.searches(), clouds.data.size() * walk.size() / 5);
}

TEST(CorrespondenceTracker, SearchesNothingWhileNothingMoves) {
  const TwoClouds clouds = DrawTwoClouds(2, {.points = 1000});
  const KdTree tree(clouds.model.positions);
  CorrespondenceTracker tracker(tree, clouds.data.positions);
  tracker.Update(clouds.T_model_data, 0.5, Parallel(1));
  EXPECT_EQ(tracker.searches(), 1000u);
  for (const double gate : {0.5, 0.4, 0.1}) tracker.Update(clouds.T_model_data, gate, Parallel(1));
  EXPECT_EQ(tracker.searches(), 1000u) << "a smaller gate needs no search either";
}

}  // namespace
}  // namespace ariadne::slam
