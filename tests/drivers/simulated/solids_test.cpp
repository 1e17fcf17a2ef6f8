#include "drivers/simulated/solids.h"

#include <gtest/gtest.h>

#include <numbers>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Of the polygon that approximates a circle, as a share of the circle's.
double AreaShare(int sides) { return std::sin(2.0 * pi / sides) * sides / (2.0 * pi); }

TEST(MakeBox, IsClosedAndFull) {
  const TriangleMesh box = MakeBox(slam::Box3(Vector3d(1, 2, 3), Vector3d(2, 4, 7)));
  EXPECT_TRUE(IsClosed(box));
  EXPECT_NEAR(Volume(box), 8.0, 1e-12);
  EXPECT_EQ(box.triangles.size(), 12u);
}

TEST(MakePrism, TakesConcaveOutlinesOfEitherOrientation) {
  std::vector<Vector2d> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}};  // a C
  EXPECT_TRUE(IsClosed(MakePrism(outline, 0.0, 2.0)));
  EXPECT_NEAR(Volume(MakePrism(outline, 0.0, 2.0)), 14.0, 1e-12);
  std::reverse(outline.begin(), outline.end());
  EXPECT_TRUE(IsClosed(MakePrism(outline, -1.0, 1.0)));
  EXPECT_NEAR(Volume(MakePrism(outline, -1.0, 1.0)), 14.0, 1e-12);
}

TEST(MakePrism, TakesStarsAndCornersOnStraightLines) {
  RandomStream stream = NamedStream(1, "stars");
  for (int round = 0; round < 50; ++round) {
    std::vector<Vector2d> star;
    double area = 0.0;
    for (int i = 0; i < 23; ++i) {
      const double angle = 2.0 * pi * i / 23, radius = DrawUniform(stream, 0.3, 3.0);
      star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Vector2d &p = star[i], &q = star[(i + 1) % star.size()];
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    const TriangleMesh prism = MakePrism(star, 0.0, 1.0);
    EXPECT_TRUE(IsClosed(prism));
    EXPECT_NEAR(Volume(prism), area, 1e-9);
  }
  const TriangleMesh square = MakePrism({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}, 0.0, 1.0);
  EXPECT_TRUE(IsClosed(square));
  EXPECT_NEAR(Volume(square), 4.0, 1e-12);
}

TEST(MakePrism, RefusesWhatIsNoSolid) {
  EXPECT_THROW(MakePrism({{0, 0}, {1, 0}}, 0, 1), Error);
  EXPECT_THROW(MakePrism({{0, 0}, {1, 0}, {1, 1}}, 1, 1), Error);
  EXPECT_THROW(MakePrism({{0, 0}, {2, 2}, {2, 0}, {0.5, 2}}, 0, 1), Error) << "it crosses itself";
}

TEST(MakeCylinder, IsClosedAndFull) {
  const TriangleMesh cylinder = MakeCylinder(0.5, 2.0, 64);
  EXPECT_TRUE(IsClosed(cylinder));
  EXPECT_NEAR(Volume(cylinder), pi * 0.25 * 2.0 * AreaShare(64), 1e-12);
}

TEST(MakeRevolved, TakesHollowProfiles) {
  // A pot: outside up, over the rim, inside down.
  const TriangleMesh pot = MakeRevolved({{0, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 1}, {0, 1}}, 50);
  EXPECT_TRUE(IsClosed(pot));
  EXPECT_NEAR(Volume(pot), (pi * 4 * 3 - pi * 2) * AreaShare(50), 1e-9);
  EXPECT_THROW(MakeRevolved({{1, 0}, {2, 0}, {0, 3}}, 8), Error);
}

TEST(MakeEllipsoid, IsClosedAndNearlyFull) {
  const TriangleMesh ellipsoid = MakeEllipsoid({1, 2, 3}, {0.5, 1.0, 2.0}, 80);
  EXPECT_TRUE(IsClosed(ellipsoid));
  EXPECT_NEAR(Volume(ellipsoid) / (4.0 / 3.0 * pi), 1.0, 0.01);
  EXPECT_LT(Volume(ellipsoid), 4.0 / 3.0 * pi) << "its corners lie on the surface";
}

TEST(MakeRod, RunsFromEndToEnd) {
  for (const Vector3d& to :
       {Vector3d(1, 2, 3), Vector3d(0, 0, -2), Vector3d(0, 0, 2), Vector3d(-1, 0, 0)}) {
    const Vector3d from(0.5, 0.25, 0.125);
    const TriangleMesh rod = MakeRod(from, from + to, 0.1, 0.2, 16);
    EXPECT_TRUE(IsClosed(rod));
    EXPECT_NEAR(Volume(rod), pi / 3 * to.norm() * (0.01 + 0.02 + 0.04) * AreaShare(16), 1e-9);
    for (const Vector3d& v : rod.vertices) {
      const double along = (v - from).dot(to.normalized());
      EXPECT_GE(along, -1e-9);
      EXPECT_LE(along, to.norm() + 1e-9);
    }
  }
}

TEST(Append, KeepsBothPartsClosed) {
  TriangleMesh mesh = MakeCylinder(1.0, 1.0);
  const double one = Volume(mesh);
  Append(mesh, Moved(MakeCylinder(1.0, 1.0), {Eigen::Quaterniond::Identity(), Vector3d(5, 0, 0)}));
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), 2.0 * one, 1e-12);
}

TEST(IsClosed, SeesHolesAndFlippedTriangles) {
  TriangleMesh box = MakeBox(slam::Box3(Vector3d(0, 0, 0), Vector3d(1, 1, 1)));
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  EXPECT_FALSE(IsClosed(box));
  box.triangles.erase(box.triangles.begin() + 3);
  EXPECT_FALSE(IsClosed(box));
  EXPECT_FALSE(IsClosed({}));
}

}  // namespace
}  // namespace ariadne::drivers
