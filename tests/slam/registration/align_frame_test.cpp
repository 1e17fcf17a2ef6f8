// The result does not depend on the frames in which the clouds are given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "slam/registration/align.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

class AlignInAnyFrame : public testing::TestWithParam<Metric> {
 protected:
  AlignInAnyFrame() { options_.metric = GetParam(); }

  /// Aligns the clouds after both have been given in other frames.
  AlignResult AlignMoved(const Pose3& T_new_model, const Pose3& T_new_data) const {
    return Align(Transformed(T_new_model, clouds_.model), Transformed(T_new_data, clouds_.data),
                 T_new_model * clouds_.T_model_data_guess * T_new_data.Inverse(), options_);
  }

  const TwoClouds clouds_ =
      DrawTwoClouds(1, {.points = 1500, .outliers = 0.05, .start_translation = 0.2, .start_angle = 4.0});
  AlignOptions options_;
};
INSTANTIATE_TEST_SUITE_P(Metrics, AlignInAnyFrame,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(AlignInAnyFrame, FindsTheSameRelativePose) {
  const AlignResult expected = AlignMoved(Pose3(), Pose3());
  ASSERT_TRUE(expected.converged()) << expected.message;
  RandomStream stream = NamedStream(1, "align_frame_test");
  for (const double offset : {0.0, 1.0, 100.0}) {
    const Pose3 together{ExpSo3(2.0 * DrawDirection(stream)), offset * DrawDirection(stream)};
    const Pose3 alone{ExpSo3(2.0 * DrawDirection(stream)), offset * DrawDirection(stream)};
    for (const Pose3& T_new_data : {together, alone}) {
      const AlignResult result = AlignMoved(together, T_new_data);
      EXPECT_EQ(result.pairs, expected.pairs);
      EXPECT_NEAR(result.rms, expected.rms, 1e-9);
      EXPECT_THAT(together.Inverse() * result.T_model_data * T_new_data,
                  NearPose(expected.T_model_data, 1e-9));
    }
  }
}

TEST_P(AlignInAnyFrame, HasTheSameCovarianceInEveryModelFrame) {
  // A covariance lives in the data frame.
  const AlignResult expected = AlignMoved(Pose3(), Pose3());
  const Pose3 far{ExpSo3({0.3, -0.8, 1.2}), {60.0, -70.0, 40.0}};
  const Pose3::Square& covariance = expected.assessment->covariance;
  EXPECT_THAT(AlignMoved(far, Pose3()).assessment->covariance,
              NearMatrix(covariance, 1e-6 * covariance.norm()));
}

TEST_P(AlignInAnyFrame, HasACovarianceThatMovesWithTheData) {
  // By the adjoint; not exactly, since the cells of space in which it is gathered move as well.
  const Pose3 far{ExpSo3({0.3, -0.8, 1.2}), {6.0, -7.0, 4.0}};
  const Pose3::Square covariance = AlignMoved(Pose3(), Pose3()).assessment->covariance;
  const Pose3::Square moved = AlignMoved(Pose3(), far).assessment->covariance;
  const Pose3::Square back = far.Inverse().Adjoint() * moved * far.Inverse().Adjoint().transpose();
  for (int k = 0; k < 6; ++k) {
    const double ratio = back(k, k) / covariance(k, k);
    EXPECT_GT(ratio, 0.4) << k;
    EXPECT_LT(ratio, 2.5) << k;
  }
}

}  // namespace
}  // namespace ariadne::slam
