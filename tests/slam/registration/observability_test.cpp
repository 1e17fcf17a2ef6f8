#include "slam/registration/observability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "slam/geometry/so3.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

/// Points of surfaces with their normals.
class Surfaces {
 public:
  void Add(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    points_.push_back(p);
    normals_.push_back(normal);
  }
  /// A rectangle of points: center + s * u + t * v for s, t in [-1, 1].
  void AddRectangle(const Eigen::Vector3d& center, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    for (double s = -0.95; s < 1.0; s += 0.1) {
      for (double t = -0.95; t < 1.0; t += 0.1) Add(center + s * u + t * v, u.cross(v).normalized());
    }
  }
  Observability Observe(double min_share) const {
    const Eigen::Vector3d center = CentroidOf(points_);
    double squared = 0.0;
    for (const Eigen::Vector3d& p : points_) squared += (p - center).squaredNorm();
    const double length = std::sqrt(squared / static_cast<double>(points_.size()));
    Pose3::Square sum = Pose3::Square::Zero();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Pose3::Tangent j;
      j << normals_[i], (points_[i] - center).cross(normals_[i]) / length;
      sum += j * j.transpose();
    }
    return ObserveMotions(sum, points_.size(), min_share);
  }

 private:
  std::vector<Eigen::Vector3d> points_, normals_;
};

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

Surfaces Corridor() {
  Surfaces corridor;  // 10 m long, 3 m wide, 3 m high, open at both ends
  for (const double side : {-1.5, 1.5}) {
    corridor.AddRectangle(side * kY, 5.0 * kX, 1.5 * kZ);
    corridor.AddRectangle(side * kZ, 5.0 * kX, 1.5 * kY);
  }
  return corridor;
}

/// How much of a motion is in the degenerate directions, 1 for all.
double DegenerateShare(const Observability& observability, const Pose3::Tangent& motion) {
  double squared = 0.0;
  for (int i = 0; i < observability.degenerate; ++i) {
    squared += std::pow(observability.directions.col(i).dot(motion), 2);
  }
  return std::sqrt(squared);
}

TEST(ObserveMotions, FindsTheAxisOfACorridor) {
  const Observability corridor = Corridor().Observe(0.01);
  EXPECT_EQ(corridor.degenerate, 1);
  EXPECT_NEAR(DegenerateShare(corridor, Pose3::Tangent::Unit(0)), 1.0, 1e-12);
  EXPECT_NEAR(corridor.shares[0], 0.0, 1e-12);
  EXPECT_THAT(corridor.DescribeDegenerate(),
              testing::MatchesRegex("moves along \\(-?1.00, -?0.00, -?0.00\\)"));
}

TEST(ObserveMotions, IsContentWithACorridorThatHasAnEnd) {
  Surfaces closed = Corridor();
  closed.AddRectangle(5.0 * kX, 1.5 * kY, 1.5 * kZ);
  EXPECT_EQ(closed.Observe(0.01).degenerate, 0);
  EXPECT_EQ(closed.Observe(0.01).DescribeDegenerate(), "");
}

TEST(ObserveMotions, AsksForTheShareThatItIsGiven) {
  Surfaces corridor = Corridor();
  for (int i = 0; i < 40; ++i) corridor.Add({5.0, 0.05 * i - 1.0, 0.0}, kX);  // 2.4 % of all
  EXPECT_EQ(corridor.Observe(0.01).degenerate, 0);
  EXPECT_EQ(corridor.Observe(0.05).degenerate, 1);
}

TEST(ObserveMotions, FindsTheThreeMotionsInAPlane) {
  Surfaces floor;
  floor.AddRectangle(-2.0 * kZ, 3.0 * kX, 2.0 * kY);
  const Observability observability = floor.Observe(0.01);
  EXPECT_EQ(observability.degenerate, 3);
  for (const int motion : {0, 1, 5}) {
    EXPECT_NEAR(DegenerateShare(observability, Pose3::Tangent::Unit(motion)), 1.0, 1e-12) << motion;
  }
  for (const int motion : {2, 3, 4}) {
    EXPECT_NEAR(DegenerateShare(observability, Pose3::Tangent::Unit(motion)), 0.0, 1e-12) << motion;
  }
}

TEST(ObserveMotions, FindsTheThreeTurnsOfASphere) {
  RandomStream stream = NamedStream(1, "observability_test/sphere");
  Surfaces sphere;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d n = DrawDirection(stream);
    sphere.Add(Eigen::Vector3d(5.0, 0.0, 0.0) + 2.0 * n, n);
  }
  const Observability observability = sphere.Observe(0.01);
  EXPECT_EQ(observability.degenerate, 3);
  EXPECT_THAT(observability.DescribeDegenerate(),
              testing::MatchesRegex("turns about \\(.*\\), turns about \\(.*\\), turns about \\(.*\\)"));
}

TEST(ObserveMotions, SeesEachMotionInARoom) {
  Surfaces room = Corridor();
  for (const double side : {-5.0, 5.0}) room.AddRectangle(side * kX, 1.5 * kY, 1.5 * kZ);
  const Observability observability = room.Observe(0.01);
  EXPECT_EQ(observability.degenerate, 0);
  EXPECT_LE(observability.shares.sum(), 2.0) << "three shares of translations, three of rotations";
  for (int i = 1; i < 6; ++i) EXPECT_LE(observability.shares[i - 1], observability.shares[i]);
}

TEST(ObserveMotions, SeesNothingWithoutPairs) {
  const Observability nothing = ObserveMotions(Pose3::Square::Zero(), 0, 0.01);
  EXPECT_EQ(nothing.degenerate, 6);
  EXPECT_EQ(nothing.shares, Pose3::Tangent::Zero());
}

TEST(Observability, DescribesMovesAndTurns) {
  Observability observability;
  observability.degenerate = 2;
  observability.directions.col(0) << 0.8, 0.0, -0.4, 0.1, 0.0, 0.0;
  observability.directions.col(1) << 0.1, 0.0, 0.0, 0.0, 0.0, 0.5;
  EXPECT_EQ(observability.DescribeDegenerate(),
            "moves along (0.89, 0.00, -0.45), turns about (0.00, 0.00, 1.00)");
}

}  // namespace
}  // namespace ariadne::slam
