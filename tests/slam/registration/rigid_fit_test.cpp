#include "slam/registration/rigid_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points Moved(const Pose3& T, const Points& points) {
  Points moved;
  for (const Eigen::Vector3d& p : points) moved.push_back(T * p);
  return moved;
}

PairMoments MomentsOf(const Points& model, const Points& data, double w = 1.0) {
  PairMoments moments;
  for (std::size_t i = 0; i < data.size(); ++i) moments.Add(model[i], data[i], w, 0.0);
  return moments;
}

double CostOf(const Points& model, const Points& data, const Pose3& T) {
  double sum = 0.0;
  for (std::size_t i = 0; i < data.size(); ++i) sum += (model[i] - T * data[i]).squaredNorm();
  return sum;
}

class RigidFitBy : public testing::TestWithParam<RigidFit (*)(const PairMoments&)> {
 protected:
  RigidFit Fit(const Points& model, const Points& data) const { return GetParam()(MomentsOf(model, data)); }

  RandomStream stream_ = NamedStream(1, "rigid_fit_test");
};
INSTANTIATE_TEST_SUITE_P(Methods, RigidFitBy, testing::Values(FitByQuaternion, FitBySvd),
                         [](const auto& method) { return method.index == 0 ? "Quaternion" : "Svd"; });

TEST_P(RigidFitBy, RecoversTheMotionOfExactPairs) {
  for (int i = 0; i < 200; ++i) {
    const Points data = DrawCloud(stream_, 10, 2.0);
    const Pose3 T = DrawMotion(stream_, 5.0, std::numbers::pi);
    const RigidFit fit = Fit(Moved(T, data), data);
    EXPECT_TRUE(fit.unique);
    EXPECT_THAT(fit.T_model_data, NearPose(T, 1e-13));
  }
}

TEST_P(RigidFitBy, RecoversHalfTurns) {
  const Points data = DrawCloud(stream_, 10, 2.0);
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
                                      Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, 0.0, -0.8)}) {
    const Pose3 T{ExpSo3(std::numbers::pi * axis), {1.0, 2.0, 3.0}};
    EXPECT_THAT(Fit(Moved(T, data), data).T_model_data, NearPose(T, 1e-13));
  }
}

TEST_P(RigidFitBy, RecoversTheMotionOfAPlane) {
  Points data = DrawCloud(stream_, 10, 2.0);
  for (Eigen::Vector3d& p : data) p.z() = 0.7;
  const Pose3 T = DrawMotion(stream_, 5.0, std::numbers::pi);
  const RigidFit fit = Fit(Moved(T, data), data);
  EXPECT_TRUE(fit.unique);
  EXPECT_THAT(fit.T_model_data, NearPose(T, 1e-13));
}

TEST_P(RigidFitBy, IsAMinimumWhereNothingFitsExactly) {
  for (int i = 0; i < 50; ++i) {
    const Points data = DrawCloud(stream_, 10, 2.0), model = DrawCloud(stream_, 10, 2.0);
    const Pose3 best = Fit(model, data).T_model_data;
    for (int k = 0; k < 20; ++k) {
      const Pose3 other = best * DrawMotion(stream_, 0.01, 0.01);
      EXPECT_GT(CostOf(model, data, other), CostOf(model, data, best));
    }
    EXPECT_GT(CostOf(model, data, DrawMotion(stream_, 1.0, std::numbers::pi)), CostOf(model, data, best));
  }
}

TEST_P(RigidFitBy, TurnsAMirroredCloudWithoutMirroringIt) {
  const Points data = DrawCloud(stream_, 10, 2.0);
  Points mirrored = data;
  for (Eigen::Vector3d& p : mirrored) p.x() = -p.x();
  const RigidFit fit = Fit(mirrored, data);
  EXPECT_TRUE(fit.unique);
  EXPECT_NEAR(fit.T_model_data.RotationMatrix().determinant(), 1.0, 1e-14);
  EXPECT_LT(CostOf(mirrored, data, fit.T_model_data), CostOf(mirrored, data, Pose3()));
}

TEST_P(RigidFitBy, KeepsEnoughDigitsFarFromTheOrigins) {
  const Pose3 T = DrawMotion(stream_, 500.0, std::numbers::pi);
  Points data = DrawCloud(stream_, 50, 2.0);
  for (Eigen::Vector3d& p : data) p += Eigen::Vector3d(100.0, -200.0, 300.0);
  const Points model = Moved(T, data);
  const Pose3 fit = Fit(model, data).T_model_data;
  for (std::size_t i = 0; i < data.size(); ++i) EXPECT_LT((fit * data[i] - model[i]).norm(), 1e-9);
}

TEST_P(RigidFitBy, IsNotUniqueOnALineOrInAPoint) {
  const Pose3 T = DrawMotion(stream_, 5.0, 1.0);
  Points line;
  for (int i = 0; i < 20; ++i) line.emplace_back(0.3 * i, -0.2 * i, 0.1 * i);
  EXPECT_FALSE(Fit(Moved(T, line), line).unique);
  const Points same(20, {1.0, 2.0, 3.0});
  EXPECT_FALSE(Fit(Moved(T, same), same).unique);
  EXPECT_FALSE(Fit(line, same).unique);
  line.emplace_back(0.0, 0.01, 0.0);  // a centimetre beside it is enough
  EXPECT_TRUE(Fit(Moved(T, line), line).unique);
}

TEST_P(RigidFitBy, WeighsAPairAsItsWeightSays) {
  const Points data = DrawCloud(stream_, 8, 2.0), model = DrawCloud(stream_, 8, 2.0);
  PairMoments heavy = MomentsOf(model, data);
  heavy.Add(model[3], data[3], 2.0, 0.0);
  PairMoments thrice = MomentsOf(model, data);
  for (int i = 0; i < 2; ++i) thrice.Add(model[3], data[3], 1.0, 0.0);
  EXPECT_THAT(GetParam()(heavy).T_model_data, NearPose(GetParam()(thrice).T_model_data, 1e-13));
  EXPECT_GT(RotationDistance(GetParam()(heavy).T_model_data, Fit(model, data).T_model_data), 1e-3);
  EXPECT_THAT(GetParam()(MomentsOf(model, data, 1e-6)).T_model_data,
              NearPose(Fit(model, data).T_model_data, 1e-12));
}

TEST(RigidFit, IsTheSameByQuaternionAndBySvd) {
  RandomStream stream = NamedStream(1, "rigid_fit_test/same");
  for (int i = 0; i < 1000; ++i) {
    const Points data = DrawCloud(stream, 12, 2.0);
    Points model = Moved(DrawMotion(stream, 3.0, std::numbers::pi), data);
    const double sigma = DrawUniform(stream, 0.0, 1.0);
    for (Eigen::Vector3d& p : model) p += DrawNoise(stream, sigma);
    const RigidFit by_quaternion = FitByQuaternion(MomentsOf(model, data));
    const RigidFit by_svd = FitBySvd(MomentsOf(model, data));
    EXPECT_THAT(by_quaternion.T_model_data, NearPose(by_svd.T_model_data, 1e-12));
    EXPECT_EQ(by_quaternion.unique, by_svd.unique);
  }
}

TEST(PairMoments, AddUp) {
  RandomStream stream = NamedStream(1, "rigid_fit_test/sum");
  const Points data = DrawCloud(stream, 9, 2.0), model = DrawCloud(stream, 9, 2.0);
  PairMoments first, second, all;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double w = 0.25 * static_cast<double>(i + 1);
    (i < 4 ? first : second).Add(model[i], data[i], w, 2.0);
    all.Add(model[i], data[i], w, 2.0);
  }
  first += second;
  EXPECT_TRUE(first.sum.isApprox(all.sum, 1e-14));
  EXPECT_EQ(first.pairs, 9u);
  EXPECT_DOUBLE_EQ(first.weight(), 0.25 * 45.0);
  EXPECT_DOUBLE_EQ(first.sum_squared_distance, 2.0 * 0.25 * 45.0);
}

}  // namespace
}  // namespace ariadne::slam
