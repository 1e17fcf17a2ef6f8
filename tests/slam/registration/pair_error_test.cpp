// How a pair's difference is measured by the two plane metrics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "slam/registration/gauss_newton.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

constexpr double kThickness = 1e-3;  // of a plane's covariance across it, 1 along it

/// One pair of points, each with a normal.
struct Pair {
  std::vector<Eigen::Vector3d> model, data;
  std::vector<SurfacePoint> model_surfaces, data_surfaces;
  Pose3 T_model_data;

  PairError ErrorBy(Metric metric) const {
    const PlaneMetric planes{model, model_surfaces, data, data_surfaces, metric};
    return planes.Error(0, 0, T_model_data, T_model_data.RotationMatrix().transpose());
  }
  Eigen::Vector3d DifferenceInModel() const { return T_model_data * data[0] - model[0]; }
};

Pair DrawPair(RandomStream& stream, const Eigen::Vector3d& model_normal,
              const Eigen::Vector3d& data_normal_in_model) {
  Pair pair;
  pair.T_model_data = DrawMotion(stream, 3.0, 3.0);
  pair.model = {DrawInCube(stream, 2.0)};
  pair.data = {pair.T_model_data.Inverse() * (pair.model[0] + DrawInCube(stream, 0.3))};
  pair.model_surfaces = {{model_normal, false, 0.1}};
  pair.data_surfaces = {{pair.T_model_data.rotation.conjugate() * data_normal_in_model, false, 0.1}};
  return pair;
}

Eigen::Matrix3d PlaneCovariance(const Eigen::Vector3d& normal) {
  return Eigen::Matrix3d::Identity() - (1.0 - kThickness) * normal * normal.transpose();
}

TEST(PairError, IsThePointsDifferenceInTheDataFrame) {
  RandomStream stream = NamedStream(1, "pair_error_test/difference");
  for (int i = 0; i < 20; ++i) {
    const Pair pair = DrawPair(stream, DrawDirection(stream), DrawDirection(stream));
    for (const Metric metric : {Metric::kPointToPlane, Metric::kPlaneToPlane}) {
      EXPECT_THAT(pair.T_model_data.rotation * pair.ErrorBy(metric).e,
                  NearMatrix(pair.DifferenceInModel(), 1e-14));
    }
  }
}

TEST(PairError, OfPointToPlaneIsTheDistanceToTheModelsPlane) {
  RandomStream stream = NamedStream(1, "pair_error_test/plane");
  for (int i = 0; i < 100; ++i) {
    const Pair pair = DrawPair(stream, DrawDirection(stream), DrawDirection(stream));
    const PairError error = pair.ErrorBy(Metric::kPointToPlane);
    const double distance = pair.model_surfaces[0].normal.dot(pair.DifferenceInModel());
    EXPECT_NEAR(error.Squared(), distance * distance, 1e-14);
    EXPECT_NEAR(error.e.dot(error.Information() * error.e), distance * distance, 1e-14);
  }
}

/// Generalized ICP as it is written, with an explicit inverse.
void ExpectInverseOfTheSum(const Pair& pair) {
  const Eigen::Matrix3d R = pair.T_model_data.RotationMatrix();
  const Eigen::Matrix3d sum = PlaneCovariance(pair.model_surfaces[0].normal) +
                              R * PlaneCovariance(pair.data_surfaces[0].normal) * R.transpose();
  const Eigen::Matrix3d expected = 2.0 * kThickness * sum.inverse();
  const PairError error = pair.ErrorBy(Metric::kPlaneToPlane);
  EXPECT_THAT(R * error.Information() * R.transpose(), NearMatrix(expected, 1e-12));
  const Eigen::Vector3d e = pair.DifferenceInModel();
  EXPECT_NEAR(error.Squared(), e.dot(expected * e), 1e-13);
}

TEST(PairError, OfPlaneToPlaneIsTheInverseOfTheSumOfCovariances) {
  RandomStream stream = NamedStream(1, "pair_error_test/gicp");
  for (int i = 0; i < 200; ++i) {
    ExpectInverseOfTheSum(DrawPair(stream, DrawDirection(stream), DrawDirection(stream)));
  }
}

TEST(PairError, OfPlaneToPlaneIsThatOfParallelAndRectangularNormalsToo) {
  RandomStream stream = NamedStream(1, "pair_error_test/special");
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d n = DrawDirection(stream);
    const Eigen::Vector3d across = n.unitOrthogonal();
    ExpectInverseOfTheSum(DrawPair(stream, n, n));
    ExpectInverseOfTheSum(DrawPair(stream, n, -n));
    ExpectInverseOfTheSum(DrawPair(stream, n, across));
    for (const double tilt : {1e-12, 1e-8, 1e-4}) {
      ExpectInverseOfTheSum(DrawPair(stream, n, (n + tilt * across).normalized()));
      ExpectInverseOfTheSum(DrawPair(stream, n, (tilt * n - across).normalized()));
    }
  }
}

TEST(PairError, OfPlaneToPlaneCountsAlongACommonNormalAsPointToPlane) {
  RandomStream stream = NamedStream(1, "pair_error_test/common");
  const Eigen::Vector3d n = DrawDirection(stream);
  Pair pair = DrawPair(stream, n, n);
  pair.data[0] = pair.T_model_data.Inverse() * (pair.model[0] + 0.2 * n);
  EXPECT_NEAR(pair.ErrorBy(Metric::kPlaneToPlane).Squared(), 0.04, 1e-14);
  EXPECT_NEAR(pair.ErrorBy(Metric::kPointToPlane).Squared(), 0.04, 1e-14);
}

}  // namespace
}  // namespace ariadne::slam
