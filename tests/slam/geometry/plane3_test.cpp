#include "slam/geometry/plane3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

/// A patch of a plane: points around `center`, spread over `length` and `width`, off the plane by `noise`.
struct Patch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // its z axis is the normal
  double length = 1.0;                                              // standard deviations [m]
  double width = 1.0;
  double noise = 0.0;

  Eigen::Vector3d Normal() const { return orientation * Eigen::Vector3d::UnitZ(); }
};

std::vector<Eigen::Vector3d> PointsOf(const Patch& patch, int count, RandomStream& stream) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d local{DrawNormal(stream, 0.0, patch.length), DrawNormal(stream, 0.0, patch.width),
                                DrawNormal(stream, 0.0, patch.noise)};
    points.push_back(patch.center + patch.orientation * local);
  }
  return points;
}

Eigen::Quaterniond RandomOrientation(RandomStream& stream) {
  return Pose3::Exp(TangentWith<Pose3>(0.0, 2.0, stream)).rotation;
}

PointMoments MomentsOf(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin) {
  PointMoments moments(origin);
  for (const Eigen::Vector3d& p : points) moments.Add(p);
  return moments;
}

/// The sine of the angle between two directions, whatever their signs.
double SineBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.cross(b).norm(); }

std::vector<Patch> Patches() {
  RandomStream stream = NamedStream(1, "plane3_test/patches");
  std::vector<Patch> patches;
  for (const double distance : {0.0, 10.0, 1e4}) {
    for (const double length : {0.05, 1.0, 20.0}) {
      for (const double aspect : {1.0, 0.5, 0.1}) {
        for (int repeat = 0; repeat < 5; ++repeat) {
          const Pose3 pose = Pose3::Exp(TangentWith<Pose3>(distance, 2.0, stream));
          patches.push_back({pose.translation, pose.rotation, length, aspect * length});
        }
      }
    }
  }
  return patches;
}

TEST(Plane3, DistanceIsPositiveOnTheSideOfTheNormal) {
  const Plane3 ceiling{Eigen::Vector3d::UnitZ(), 2.5};
  EXPECT_DOUBLE_EQ(ceiling.Distance({7.0, -3.0, 3.0}), 0.5);
  EXPECT_DOUBLE_EQ(ceiling.Distance({7.0, -3.0, 2.0}), -0.5);
  const Plane3 oblique{Eigen::Vector3d(0.6, 0.8, 0.0), 5.0};
  EXPECT_DOUBLE_EQ(oblique.Distance({3.0, 4.0, 100.0}), 0.0);
}

TEST(Plane3, MovesWithItsPoints) {
  RandomStream stream = NamedStream(1, "plane3_test/move");
  for (const Pose3& T_a_b : SamplePoses<Pose3>()) {
    const Plane3 plane_b{RandomDirection<3>(stream), DrawUniform(stream, -5.0, 5.0)};
    const Plane3 plane_a = T_a_b * plane_b;
    EXPECT_NEAR(plane_a.normal.norm(), 1.0, 1e-15);
    for (int repeat = 0; repeat < 3; ++repeat) {
      const Eigen::Vector3d p_b = 10.0 * RandomDirection<3>(stream);
      EXPECT_NEAR(plane_a.Distance(T_a_b * p_b), plane_b.Distance(p_b), 4e-14);
    }
  }
}

TEST(PointMoments, AreThoseOfTwoPassesWhateverTheOrigin) {
  RandomStream stream = NamedStream(1, "plane3_test/moments");
  const auto points = PointsOf({{1.0, 2.0, 3.0}, RandomOrientation(stream), 2.0, 1.0, 0.5}, 100, stream);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p / 100.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose() / 100.0;
  for (const Eigen::Vector3d& origin : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(-5.0, 3.0, 8.0)}) {
    const PointMoments moments = MomentsOf(points, origin);
    EXPECT_EQ(moments.count(), 100);
    EXPECT_THAT(moments.Mean(), NearMatrix(mean, 1e-14));
    EXPECT_THAT(moments.Covariance(), NearMatrix(covariance, 2e-13));
  }
}

TEST(PointMoments, KeepTheirDigitsFarAwayWithAnOriginNearThePoints) {
  RandomStream stream = NamedStream(1, "plane3_test/far");
  const auto near = PointsOf({{}, RandomOrientation(stream), 0.05, 0.05, 0.01}, 50, stream);
  const Eigen::Vector3d shift(8192.0, -16384.0, 4096.0);
  std::vector<Eigen::Vector3d> far;
  for (const Eigen::Vector3d& p : near) far.push_back(p + shift);
  EXPECT_THAT(MomentsOf(far, far.front()).Covariance(),
              NearMatrix(MomentsOf(near, near.front()).Covariance(), 1e-12));
}

TEST(FitPlane, FindsExactPlanesNearAndFar) {
  RandomStream stream = NamedStream(1, "plane3_test/exact");
  for (const Patch& patch : Patches()) {
    const auto points = PointsOf(patch, 30, stream);
    const PlaneFit fit = FitPlane(MomentsOf(points, points.front()));
    const double rounding = 1e-15 * (patch.center.norm() + patch.length);
    EXPECT_NEAR(fit.plane.normal.norm(), 1.0, 1e-15);
    EXPECT_LE(SineBetween(fit.plane.normal, patch.Normal()), 1e-11 + 10.0 * rounding / patch.width);
    for (const Eigen::Vector3d& p : points) {
      EXPECT_NEAR(fit.plane.Distance(p), 0.0, 4.0 * rounding + 1e-11 * patch.length);
    }
    EXPECT_GE(fit.variances[0], 0.0);
    EXPECT_LE(fit.variances[0], 1e-13 * patch.length * patch.length + rounding * rounding);
  }
}

TEST(FitPlane, ReportsTheVariancesAlongItsAxes) {
  RandomStream stream = NamedStream(1, "plane3_test/variances");
  const Patch patch{{100.0, -50.0, 2.0}, RandomOrientation(stream), 2.0, 0.5, 0.01};
  const auto points = PointsOf(patch, 2000, stream);
  const PlaneFit fit = FitPlane(MomentsOf(points, patch.center));
  EXPECT_NEAR(std::sqrt(fit.variances[0]), patch.noise, 0.1 * patch.noise);
  EXPECT_NEAR(std::sqrt(fit.variances[1]), patch.width, 0.1 * patch.width);
  EXPECT_NEAR(std::sqrt(fit.variances[2]), patch.length, 0.1 * patch.length);
  double squares = 0.0;
  for (const Eigen::Vector3d& p : points) squares += std::pow(fit.plane.Distance(p), 2) / 2000.0;
  EXPECT_NEAR(squares, fit.variances[0], 1e-9) << "the first is the mean square of the distances";
}

TEST(FitPlane, StaysWithinTheNoiseNearAndFar) {
  RandomStream stream = NamedStream(1, "plane3_test/noisy");
  for (Patch patch : Patches()) {
    patch.noise = 0.02 * patch.width;
    const auto points = PointsOf(patch, 400, stream);
    const PlaneFit fit = FitPlane(MomentsOf(points, points.front()));
    const double sigma = patch.noise / 20.0;  // of a mean of 400
    EXPECT_LE(SineBetween(fit.plane.normal, patch.Normal()), 5.0 * sigma / patch.width);
    EXPECT_NEAR(fit.plane.Distance(patch.center), 0.0, 5.0 * sigma);
  }
}

TEST(FitPlane, MinimizesTheSquaredDistances) {
  RandomStream stream = NamedStream(1, "plane3_test/minimum");
  const auto points = PointsOf({{3.0, 2.0, 1.0}, RandomOrientation(stream), 1.0, 0.5, 0.1}, 50, stream);
  const auto cost = [&](const Plane3& plane) {
    double sum = 0.0;
    for (const Eigen::Vector3d& p : points) sum += plane.Distance(p) * plane.Distance(p);
    return sum;
  };
  const Plane3 best = FitPlane(MomentsOf(points, {3.0, 2.0, 1.0})).plane;
  for (int repeat = 0; repeat < 50; ++repeat) {
    const Plane3 moved = Pose3::Exp(TangentWith<Pose3>(1e-3, 1e-3, stream)) * best;
    EXPECT_LE(cost(best), cost(moved));
  }
}

TEST(FitPlane, OfDegeneratePointsIsFinite) {
  const Eigen::Vector3d p(5.0, -3.0, 1.0);
  for (const Eigen::Vector3d& step : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, 2.0, -0.5)}) {
    const PlaneFit fit = FitPlane(MomentsOf({p, p + step, p + 2.0 * step, p + 4.0 * step}, p));
    EXPECT_NEAR(fit.plane.normal.norm(), 1.0, 1e-15);
    EXPECT_NEAR(fit.plane.Distance(p), 0.0, 1e-7);
    EXPECT_NEAR(fit.variances[1], 0.0, 1e-14) << "no second axis: the plane is not determined";
  }
}

}  // namespace
}  // namespace ariadne::slam
