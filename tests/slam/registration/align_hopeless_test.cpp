// Input from which no pose can be found ends in a status and a sentence, and never looks like a success.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "slam/registration/align.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/error_of.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

using testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PointCloud CloudOf(std::vector<Eigen::Vector3d> positions) { return {std::move(positions), {}, {}, {}}; }

class HopelessBy : public testing::TestWithParam<Metric> {
 protected:
  HopelessBy() { options_.metric = GetParam(); }

  AlignResult Run(const PointCloud& model, const PointCloud& data, const Pose3& guess = {}) const {
    const AlignResult result = Align(model, data, guess, options_);
    EXPECT_FALSE(result.message.empty());
    return result;
  }
  bool planes() const { return GetParam() != Metric::kPointToPoint; }

  RandomStream stream_ = NamedStream(1, "align_hopeless_test");
  const TwoClouds clouds_ = DrawTwoClouds(1, {.points = 300, .start_translation = 0.1, .start_angle = 2.0});
  AlignOptions options_;
};
INSTANTIATE_TEST_SUITE_P(Metrics, HopelessBy,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(HopelessBy, ZeroPairs) {
  const Pose3 far{Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}};
  const AlignResult result = Run(clouds_.model, clouds_.data, far);
  EXPECT_EQ(result.status, AlignStatus::kTooFewPairs);
  EXPECT_EQ(result.pairs, 0u);
  EXPECT_EQ(result.message,
            "0 pairs within 0.5 m in iteration 1, at least 10 are needed: the guess is too far off, or the "
            "clouds do not overlap");
  EXPECT_THAT(result.T_model_data, NearPose(far, 0.0));
}

TEST_P(HopelessBy, OnePair) {
  EXPECT_EQ(Run(CloudOf({{1.0, 2.0, 3.0}}), CloudOf({{1.1, 2.0, 3.0}})).status, AlignStatus::kTooFewPairs);
  PointCloud apart = Transformed({Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}}, clouds_.data);
  apart.positions[7] = clouds_.model.positions[3];
  EXPECT_EQ(Run(clouds_.model, apart).status, AlignStatus::kTooFewPairs);
}

TEST_P(HopelessBy, FewerPairsThanAskedFor) {
  options_.max_distance = 0.2;
  const std::size_t pairs = Run(clouds_.model, clouds_.data, clouds_.T_model_data).pairs;
  ASSERT_GT(pairs, 20u);
  options_.min_pairs = 290;
  EXPECT_EQ(Run(clouds_.model, clouds_.data, clouds_.T_model_data).status, AlignStatus::kTooFewPairs);
}

TEST_P(HopelessBy, Collinear) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 100; ++i) line.emplace_back(0.05 * i, 0.02 * i, -0.01 * i);
  const AlignResult result = Run(CloudOf(line), CloudOf(line), DrawMotion(stream_, 0.01, 0.01));
  EXPECT_EQ(result.status, planes() ? AlignStatus::kTooFewPairs : AlignStatus::kNotUnique);
  if (!planes()) {
    EXPECT_THAT(result.message, testing::HasSubstr("pairs lie on one line, which leaves a rotation open"));
  }
}

TEST_P(HopelessBy, NearlyCollinear) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 200; ++i) {
    line.push_back(Eigen::Vector3d(0.05 * i, 0.0, 0.0) + DrawNoise(stream_, 0.0005));
  }
  EXPECT_FALSE(Run(CloudOf(line), CloudOf(line), DrawMotion(stream_, 0.01, 0.01)).converged());
}

TEST_P(HopelessBy, Coplanar) {
  for (const double sigma : {0.0, 0.005}) {
    std::vector<Eigen::Vector3d> model(800), data(800);
    for (auto* const floor : {&model, &data}) {
      for (Eigen::Vector3d& p : *floor) {
        p = DrawInBox(stream_, {-2.0, -2.0, 0.0}, {2.0, 2.0, 0.0});
        p.z() = DrawNormal(stream_, 0.0, sigma);
      }
    }
    const AlignResult result = Run(CloudOf(model), CloudOf(data), DrawMotion(stream_, 0.05, 0.02));
    EXPECT_EQ(result.status, AlignStatus::kDegenerate) << result.message;
    EXPECT_THAT(result.message, testing::HasSubstr("do not hold the data against a motion that"));
    EXPECT_EQ(result.assessment->observability.degenerate, 3);
    // Nothing holds x: its sigma is the gate, not what noise alone would leave.
    EXPECT_GT(std::sqrt(result.assessment->covariance(0, 0)), 0.4);
    EXPECT_LT(std::sqrt(result.assessment->covariance(2, 2)), 0.01);
  }
}

TEST_P(HopelessBy, PointsThatFillSpace) {
  const PointCloud cloud = CloudOf(DrawCloud(stream_, 500, 1.0));
  options_.max_distance = 0.05;
  EXPECT_NO_THROW(Run(cloud, cloud, DrawMotion(stream_, 0.01, 0.01)));
}

TEST_P(HopelessBy, TheSamePointManyTimes) {
  const PointCloud cloud = CloudOf(std::vector<Eigen::Vector3d>(50, {1.0, 2.0, 3.0}));
  EXPECT_EQ(Run(cloud, cloud).status, planes() ? AlignStatus::kTooFewPairs : AlignStatus::kNotUnique);
}

TEST_P(HopelessBy, NonFinitePoints) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    PointCloud broken = clouds_.model;
    broken.positions[17].y() = bad;
    EXPECT_EQ(Run(broken, clouds_.data).message, "point 17 of the model cloud is not finite");
    EXPECT_EQ(Run(clouds_.model, broken).message, "point 17 of the data cloud is not finite");
    EXPECT_EQ(Run(clouds_.model, broken).status, AlignStatus::kBadInput);
    EXPECT_EQ(ErrorOf([&] { PrepareModel(broken, options_); }),
              "point 17 of the model cloud is not finite");
    EXPECT_EQ(ErrorOf([&] { PrepareData(broken, options_); }), "point 17 of the data cloud is not finite");
  }
  const PointCloud nothing_but_nan = CloudOf(std::vector<Eigen::Vector3d>(50, {kNan, kNan, kNan}));
  EXPECT_EQ(Run(nothing_but_nan, nothing_but_nan).status, AlignStatus::kBadInput);
}

TEST_P(HopelessBy, NoPoints) {
  EXPECT_EQ(Run({}, clouds_.data).message, "the model cloud has no points");
  EXPECT_EQ(Run(clouds_.model, {}).message, "the data cloud has no points");
  EXPECT_EQ(Run({}, {}).status, AlignStatus::kBadInput);
  EXPECT_EQ(ErrorOf([&] { PrepareModel({}, options_); }), "the model cloud has no points");
}

TEST_P(HopelessBy, AGuessThatIsNotFinite) {
  Pose3 guess;
  guess.translation.x() = kNan;
  EXPECT_EQ(Run(clouds_.model, clouds_.data, guess).status, AlignStatus::kBadInput);
  guess = {};
  guess.rotation.w() = kNan;
  EXPECT_EQ(Run(clouds_.model, clouds_.data, guess).message, "the guess of the pose is not finite");
}

TEST_P(HopelessBy, IdenticalCloudsAreNotHopeless) {
  const AlignResult here = Run(clouds_.model, clouds_.model);
  EXPECT_TRUE(here.converged()) << here.message;
  EXPECT_THAT(here.T_model_data, NearPose(Pose3(), 1e-12));
  EXPECT_LT(here.rms, 1e-12);
  if (!planes()) {
    const AlignResult back = Run(clouds_.model, clouds_.model, DrawMotion(stream_, 0.02, 0.01));
    EXPECT_TRUE(back.converged()) << back.message;
    EXPECT_THAT(back.T_model_data, NearPose(Pose3(), 1e-12));
    EXPECT_LT(back.rms, 1e-12);
  }
}

}  // namespace
}  // namespace ariadne::slam
