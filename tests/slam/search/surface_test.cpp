#include "slam/search/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"
#include "tests/support/difficult_clouds.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

constexpr double kSpacing = 0.05;  // [m]

/// About 1 m x 1 m of the plane z = 0, its points a little off their lattice.
std::vector<Eigen::Vector3d> PlanePatch(double sigma) {
  RandomStream stream = NamedStream(1, "surface_test/plane");
  std::vector<Eigen::Vector3d> points;
  for (int x = -10; x <= 10; ++x) {
    for (int y = -10; y <= 10; ++y) {
      const Eigen::Vector3d jitter = DrawInCube(stream, 0.2);
      points.emplace_back(kSpacing * (x + jitter.x()), kSpacing * (y + jitter.y()),
                          DrawNormal(stream, 0.0, sigma));
    }
  }
  return points;
}

std::vector<Eigen::Vector3d> Moved(const Pose3& T, std::vector<Eigen::Vector3d> points) {
  for (Eigen::Vector3d& p : points) p = T * p;
  return points;
}

/// Between the directions of two normals, whatever their signs. [rad]
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

double DistanceToEnd(const Eigen::Vector3d& p) { return 10 * kSpacing - p.cwiseAbs().maxCoeff(); }

TEST(EstimateSurface, FindsThePlaneInAnyFrame) {
  RandomStream stream = NamedStream(1, "surface_test/frames");
  const auto patch = PlanePatch(0.0);
  for (int i = 0; i < 20; ++i) {
    const Pose3 T = DrawMotion(stream, i == 0 ? 0.0 : 100.0, 3.0);
    const KdTree tree(Moved(T, patch));
    for (std::size_t p = 0; p < patch.size(); p += 17) {
      const SurfacePoint surface = EstimateSurface(tree, p, 10);
      ASSERT_TRUE(surface.has_normal());
      EXPECT_NEAR(surface.normal.norm(), 1.0, 1e-12);
      EXPECT_LT(AngleBetween(surface.normal, T.rotation * Eigen::Vector3d::UnitZ()), 1e-6);
    }
  }
}

TEST(EstimateSurface, HasANormalThatFacesTheOrigin) {
  RandomStream stream = NamedStream(1, "surface_test/facing");
  const auto patch = PlanePatch(0.0);
  for (int i = 0; i < 20; ++i) {
    const Pose3 T = DrawMotion(stream, 10.0, 3.0);
    const KdTree tree(Moved(T, patch));
    // The scanner is at the origin: on which side of the plane it is, the untouched patch knows.
    const double height = (T.Inverse() * Eigen::Vector3d::Zero()).z();
    const Eigen::Vector3d towards = T.rotation * Eigen::Vector3d(0.0, 0.0, height > 0.0 ? 1.0 : -1.0);
    for (std::size_t p = 0; p < patch.size(); p += 17)
      EXPECT_GT(EstimateSurface(tree, p, 10).normal.dot(towards), 0.999) << i << ", " << height;
  }
}

TEST(EstimateSurface, AveragesNoise) {
  const KdTree tree(PlanePatch(0.005));
  double worst = 0.0, sum_squared = 0.0;
  for (std::size_t p = 0; p < tree.points().size(); ++p) {
    const SurfacePoint surface = EstimateSurface(tree, p, 20);
    ASSERT_TRUE(surface.has_normal());
    const double angle = AngleBetween(surface.normal, Eigen::Vector3d::UnitZ());
    worst = std::max(worst, angle);
    sum_squared += angle * angle;
  }
  // 20 points with a spread of 6 cm on each of two axes tilt by 5 mm / (6 cm sqrt(20)) about each.
  const double rms = std::sqrt(sum_squared / static_cast<double>(tree.points().size()));
  EXPECT_NEAR(DegFromRad(rms), 1.5, 0.5);
  EXPECT_LT(DegFromRad(worst), 6.0);
}

TEST(EstimateSurface, ReachesToTheFarthestOfTheNeighbours) {
  const KdTree tree(PlanePatch(0.005));
  std::array<Neighbor, 12> nearest;
  tree.NearestK(tree.points()[200], nearest);
  EXPECT_DOUBLE_EQ(EstimateSurface(tree, 200, 12).radius, std::sqrt(nearest.back().squared_distance));
}

TEST(EstimateSurface, FindsNoPlaneInALine) {
  RandomStream stream = NamedStream(1, "surface_test/line");
  std::vector<Eigen::Vector3d> line(50);
  const Eigen::Vector3d direction = DrawDirection(stream);
  for (Eigen::Vector3d& p : line) {
    p = DrawUniform(stream, 0.0, 1.0) * direction + DrawNoise(stream, 1e-4);
  }
  const KdTree tree(line);
  for (std::size_t p = 0; p < line.size(); ++p) EXPECT_FALSE(EstimateSurface(tree, p, 10).has_normal());
}

TEST(EstimateSurface, RarelyFindsAPlaneInPointsThatFillSpace) {
  RandomStream stream = NamedStream(1, "surface_test/volume");
  const KdTree tree(DrawCloud(stream, 2000, 1.0));
  int with_normal = 0;
  for (std::size_t p = 0; p < 2000; ++p) with_normal += EstimateSurface(tree, p, 10).has_normal();
  EXPECT_LT(with_normal, 2000 / 5);
}

TEST(EstimateSurface, TellsWhereTheScanEnds) {
  const KdTree tree(PlanePatch(0.0));
  int ends = 0, found = 0;
  for (std::size_t p = 0; p < tree.points().size(); ++p) {
    const SurfacePoint surface = EstimateSurface(tree, p, 20);
    const double to_end = DistanceToEnd(tree.points()[p]);
    if (to_end > 2.0 * kSpacing) {
      EXPECT_FALSE(surface.boundary) << tree.points()[p].transpose();
    }
    if (to_end < 0.3 * kSpacing) {
      ++ends;
      found += surface.boundary;
    }
  }
  EXPECT_GT(found, 0.6 * ends);  // not all: a neighbour or two beyond the point balance many
}

TEST(EstimateSurface, AtAnEdgeHasNoNormalOrOneAcrossTheEdge) {
  // The floor and a wall of half a metre, which meet in the y axis.
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : PlanePatch(0.0)) {
    points.push_back(p.x() < 0.0 ? p : Eigen::Vector3d(0.0, p.y(), p.x()));
  }
  const KdTree tree(points);
  int without_normal = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (std::abs(points[p].y()) > 0.3) continue;  // away from the ends of the edge
    const SurfacePoint surface = EstimateSurface(tree, p, 10);
    const double to_edge = std::hypot(points[p].x(), points[p].z());
    const Eigen::Vector3d face = points[p].z() > 0.0 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    if (to_edge > surface.radius) {
      EXPECT_LT(AngleBetween(surface.normal, face), 1e-6);
    } else if (surface.has_normal()) {
      EXPECT_LT(std::abs(surface.normal.y()), 0.4);
    }
    without_normal += !surface.has_normal();
  }
  EXPECT_GT(without_normal, 0);
}

TEST(EstimateSurface, NeedsThreeDifferentPoints) {
  const Eigen::Vector3d p(1.0, 2.0, 3.0);
  EXPECT_FALSE(EstimateSurface(KdTree({p}), 0, 10).has_normal());
  EXPECT_EQ(EstimateSurface(KdTree({p}), 0, 10).radius, 0.0);
  EXPECT_FALSE(EstimateSurface(KdTree({p, {2.0, 2.0, 2.0}}), 0, 10).has_normal());
  EXPECT_FALSE(EstimateSurface(KdTree(std::vector<Eigen::Vector3d>(20, p)), 0, 10).has_normal());
  const KdTree triangle({p, {2.0, 2.0, 3.0}, {1.0, 3.0, 3.0}});
  EXPECT_LT(AngleBetween(EstimateSurface(triangle, 0, 10).normal, Eigen::Vector3d::UnitZ()), 1e-7);
}

TEST(EstimateSurfaces, IsTheSameOnAnyNumberOfThreads) {
  const KdTree tree(PlanePatch(0.005));
  for (const int threads : {1, 2, 3}) {
    const std::vector<SurfacePoint> surfaces = EstimateSurfaces(tree, 10, Parallel(threads));
    ASSERT_EQ(surfaces.size(), tree.points().size());
    for (std::size_t p = 0; p < surfaces.size(); ++p) {
      const SurfacePoint expected = EstimateSurface(tree, p, 10);
      EXPECT_EQ(surfaces[p].normal, expected.normal);
      EXPECT_EQ(surfaces[p].boundary, expected.boundary);
      EXPECT_EQ(surfaces[p].radius, expected.radius);
    }
  }
}

TEST(EstimateSurfaces, TellsHowManyNeighboursItTakes) {
  const KdTree tree({{1.0, 2.0, 3.0}});
  for (const int neighbors : {-1, 2, 65}) {
    EXPECT_EQ(ErrorOf([&] { EstimateSurfaces(tree, neighbors, Parallel(1)); }),
              "a surface takes 3 to 64 neighbours, not " + std::to_string(neighbors));
  }
}

}  // namespace
}  // namespace ariadne::slam
