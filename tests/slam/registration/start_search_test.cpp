#include "slam/registration/start_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

AlignOptions SearchWithin(double radius, int threads = 1) {
  AlignOptions options;
  options.metric = Metric::kPointToPlane;
  options.search_radius = radius;
  options.threads = threads;
  return options;
}

class FindStartIn : public testing::TestWithParam<int> {
 protected:
  Pose3 Find(const Pose3& guess, const AlignOptions& options) const {
    return FindStart(PrepareModel(clouds_.model, options), PrepareData(clouds_.data, options), guess,
                     options);
  }
  double ErrorOf(const Pose3& T_model_data) const {
    const Eigen::Vector3d center = CentroidOf(clouds_.data.positions);
    return (T_model_data * center - clouds_.T_model_data * center).norm();
  }

  const TwoClouds clouds_ = DrawTwoClouds(static_cast<std::uint64_t>(GetParam()), {.points = 2000});
};
INSTANTIATE_TEST_SUITE_P(Rooms, FindStartIn, testing::Range(0, 3));

TEST_P(FindStartIn, ComesNearTheTruthFromAMetreAway) {
  const Eigen::Vector3d center = CentroidOf(clouds_.data.positions);
  RandomStream stream = NamedStream(1, "start_search_test");
  const Pose3 error{ExpSo3(RadFromDeg(10.0) * DrawDirection(stream)), 0.9 * DrawDirection(stream)};
  const Pose3 start = Find(clouds_.T_model_data * AboutPoint(center, error), SearchWithin(1.0));
  EXPECT_LT(ErrorOf(start), 0.15);
  EXPECT_LT(RotationDistance(start, clouds_.T_model_data), RadFromDeg(5.0));
}

TEST_P(FindStartIn, StaysNearTheTruth) {
  EXPECT_LT(ErrorOf(Find(clouds_.T_model_data, SearchWithin(1.0))), 0.15);
}

TEST_P(FindStartIn, FindsTheSameOnAnyNumberOfThreads) {
  const Pose3 serial = Find(clouds_.T_model_data_guess, SearchWithin(1.0));
  const Pose3 parallel = Find(clouds_.T_model_data_guess, SearchWithin(1.0, 2));
  EXPECT_EQ(parallel.rotation.coeffs(), serial.rotation.coeffs());
  EXPECT_EQ(parallel.translation, serial.translation);
}

TEST_P(FindStartIn, KeepsTheGuessWhereNothingIsNear) {
  const Pose3 far{Eigen::Quaterniond::Identity(), {500.0, 0.0, 0.0}};
  const Pose3 guess = far * clouds_.T_model_data;
  EXPECT_THAT(Find(guess, SearchWithin(1.0)), NearPose(guess, 1e-15));
}

}  // namespace
}  // namespace ariadne::slam
