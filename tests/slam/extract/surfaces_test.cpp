#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/random.h"
#include "slam/extract/extract_surfaces.h"
#include "slam/geometry/angles.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

/// Where the beam of a pitch and bearing (from the right) meets the plane, if it does within 15 m.
std::optional<Eigen::Vector3d> Meet(const Plane3& plane, double pitch, double bearing) {
  const Eigen::Vector3d u(std::sin(bearing) * std::cos(pitch), -std::cos(bearing),
                          std::sin(bearing) * std::sin(pitch));
  const double range = plane.offset / plane.normal.dot(u);
  if (!(range > 0.0 && range < 15.0)) return std::nullopt;
  return range * u;
}

/// A scan without errors of the first that the beams meet of some planes.
PointCloud ScanOf(const std::vector<Plane3>& planes, int slices = 60, double lowest_deg = -30.0) {
  PointCloud cloud;
  for (int s = 0; s < slices; ++s) {
    cloud.slice_begin.push_back(cloud.size());
    for (int beam = 0; beam <= 180; ++beam) {
      std::optional<Eigen::Vector3d> first;
      for (const Plane3& plane : planes) {
        const auto p = Meet(plane, RadFromDeg(lowest_deg + 0.47 * s), RadFromDeg(beam));
        if (p && (!first || p->norm() < first->norm())) first = p;
      }
      if (first) cloud.positions.push_back(*first);
    }
  }
  return cloud;
}

PlanarSurface Square(const Pose3& T_frame_plane, double edge, std::size_t points = 100) {
  const double h = 0.5 * edge;
  PlanarSurface surface;
  surface.T_frame_plane = T_frame_plane;
  surface.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
  surface.outlines = {{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}, {}}};
  surface.points = points;
  return surface;
}

Pose3 At(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), {x, y, z}}; }

TEST(PlanarSurface, MovesAsAWhole) {
  const Pose3 T{Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitX())), {1, 2, 3}};
  const PlanarSurface moved = Transformed(T, Square(At(0, 0, 1), 2.0));
  EXPECT_NEAR(Area(moved), 4.0, 1e-12);
  const Plane3 expected = T * Plane3{Eigen::Vector3d::UnitZ(), 1.0};
  EXPECT_LT((PlaneOf(moved).normal - expected.normal).norm(), 1e-12);
  EXPECT_NEAR(PlaneOf(moved).offset, expected.offset, 1e-12);
  EXPECT_TRUE(BoxAround(moved).isApprox(Box3(Eigen::Vector3d(0, 1, 2), Eigen::Vector3d(2, 1, 4))));
  EXPECT_TRUE(IsWithinOutline(moved, {1.5, 1.0, 3.5}));
  EXPECT_FALSE(IsWithinOutline(moved, {2.5, 1.0, 3.5}));
  ASSERT_EQ(OutlinePoints(moved).size(), 1u);
}

TEST(FitSurface, HasAnHonestCovariance) {
  RandomStream stream = NamedStream(3, "fit_surface");
  SliceNoise noise;
  noise.systematic_sigma = 0.0;
  noise.bearing_sigma = 0.0;
  const Plane3 truth{Eigen::Vector3d(1.0, 0.2, 0.3).normalized(), 3.0};
  double nees = 0.0;
  constexpr int kTrials = 100;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& p : ScanOf({truth}, 40).positions) {
      if (p.norm() < 5.0) points.push_back(p * (1.0 + DrawNormal(stream, 0.0, 0.006) / p.norm()));
    }
    const PlanarSurface surface = FitSurface(points, noise).value();
    EXPECT_LT(PlaneOf(surface).normal.dot(truth.normal), 0.0);  // towards the scanner
    const Eigen::Vector3d n = surface.T_frame_plane.rotation.conjugate() * Eigen::Vector3d(-truth.normal);
    const double shift = -truth.Distance(surface.T_frame_plane.translation);
    const Eigen::Vector3d error(-n.y() / n.z(), n.x() / n.z(), -shift);
    nees += error.dot(surface.covariance.ldlt().solve(error)) / kTrials;
  }
  EXPECT_NEAR(nees, 3.0, 1.0);  // noise along the beams moves points in the plane too: half a sigma of bias
}

TEST(FitSurface, IsNothingOnALine) {
  EXPECT_FALSE(FitSurface({}, {}).has_value());
  const std::vector<Eigen::Vector3d> line{{1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}};
  EXPECT_FALSE(FitSurface(line, {}).has_value());
}

class ExtractSurfacesTest : public testing::TestWithParam<SurfaceMethod> {
 protected:
  static std::vector<PlanarSurface> Extract(const PointCloud& cloud) {
    ExtractSurfacesOptions options;
    options.method = GetParam();
    return ExtractSurfaces(cloud, options);
  }
};

TEST_P(ExtractSurfacesTest, FindsTheWallAheadAndTheFloorAndNothingBetween) {
  const Plane3 ahead{Eigen::Vector3d::UnitX(), 4.0}, floor{-Eigen::Vector3d::UnitZ(), 1.0};
  const auto surfaces = Extract(ScanOf({ahead, floor}));
  ASSERT_EQ(surfaces.size(), 2u);
  for (const PlanarSurface& surface : surfaces) {
    const Plane3 plane = PlaneOf(surface);
    const bool is_floor = plane.normal.z() > 0.5;
    EXPECT_LT((plane.normal + (is_floor ? floor : ahead).normal).norm(), 0.005);
    EXPECT_NEAR(plane.offset, is_floor ? -1.0 : -4.0, 0.01);
  }
}

// Every slice holds the tilt axis, and so a line on each side wall, which all begin where the axis meets
// it.
TEST_P(ExtractSurfacesTest, FindsSideWallsThroughTheTiltAxis) {
  const Plane3 left{Eigen::Vector3d::UnitY(), 1.2};
  const Plane3 right{Eigen::Vector3d(0.1, -1.0, 0.0).normalized(), 0.8};
  const auto surfaces = Extract(ScanOf({left, right, {Eigen::Vector3d::UnitX(), 6.0}}, 80));
  ASSERT_EQ(surfaces.size(), 3u);
  for (const Plane3& wall : {left, right}) {
    EXPECT_TRUE(std::ranges::any_of(surfaces, [&](const PlanarSurface& surface) {
      return (PlaneOf(surface).normal + wall.normal).norm() < 0.005 && Area(surface) > 6.0;
    }));
  }
}

TEST_P(ExtractSurfacesTest, TakesWhatHasNoPoints) {
  EXPECT_TRUE(Extract({}).empty());
  PointCloud cloud;
  cloud.slice_begin = {0, 0, 0};
  EXPECT_TRUE(Extract(cloud).empty());
}

TEST_P(ExtractSurfacesTest, DoesNotDependOnTheSideFromWhichSlicesAreSwept) {
  PointCloud cloud = ScanOf({{Eigen::Vector3d::UnitX(), 4.0}});
  const auto rising = Extract(cloud);
  cloud.slice_begin.push_back(cloud.size());
  for (std::size_t s = 0; s + 1 < cloud.slice_begin.size(); ++s) {
    std::reverse(cloud.positions.begin() + static_cast<std::ptrdiff_t>(cloud.slice_begin[s]),
                 cloud.positions.begin() + static_cast<std::ptrdiff_t>(cloud.slice_begin[s + 1]));
  }
  cloud.slice_begin.pop_back();
  const auto falling = Extract(cloud);
  ASSERT_EQ(falling.size(), 1u);
  EXPECT_NEAR(Area(falling[0]), Area(rising[0]), 0.01);
}

INSTANTIATE_TEST_SUITE_P(, ExtractSurfacesTest,
                         testing::Values(SurfaceMethod::kLines, SurfaceMethod::kRegionGrowing),
                         [](const auto& tested) { return std::string(NameOf(tested.param)); });

TEST(ExtractSurfaces, SaysWhatItNeeds) {
  PointCloud cloud = ScanOf({{Eigen::Vector3d::UnitX(), 4.0}});
  cloud.slice_begin.clear();
  EXPECT_THAT(ErrorOf([&] { ExtractSurfaces(cloud, {}); }), testing::HasSubstr("needs the slices"));
  ExtractSurfacesOptions options;
  options.method = SurfaceMethod::kRegionGrowing;
  EXPECT_EQ(ExtractSurfaces(cloud, options).size(), 1u);
  options.regions.min_points = 0;
  EXPECT_THAT(ErrorOf([&] { ExtractSurfaces(cloud, options); }), testing::HasSubstr("regions.min_points"));
}

TEST(SurfaceGrower, BridgesAMissedSlice) {
  const PointCloud cloud = ScanOf({{Eigen::Vector3d::UnitX(), 4.0}}, 20);
  for (const int missed : {0, 2}) {
    SurfaceOptions options;
    options.max_missed_slices = missed;
    SurfaceGrower grower(options);
    for (std::size_t s = 0; s < 20; ++s) {
      grower.AddSlice(s == 9 || s == 10 ? std::vector<SpatialLine>() : SpatialLines(cloud, s, {}));
    }
    EXPECT_EQ(grower.Surfaces().size(), missed == 0 ? 2u : 1u);
  }
}

TEST(UniteSurfaces, JoinsWhatIsOnePlaneAndTouches) {
  const PlanarSurface a = Square(At(0, 0, 0), 1.0, 300);
  EXPECT_EQ(UniteSurfaces({a, Square(At(0.8, 0, 0.005), 1.0)}, {}).size(), 1u);
  EXPECT_EQ(UniteSurfaces({a, Square(At(1.2, 0, 0), 1.0)}, {}).size(), 1u);    // a gap of 0.2 m
  EXPECT_EQ(UniteSurfaces({a, Square(At(2.0, 0, 0), 1.0)}, {}).size(), 2u);    // too far
  EXPECT_EQ(UniteSurfaces({a, Square(At(0.8, 0, 0.1), 1.0)}, {}).size(), 2u);  // a step
  const Eigen::Quaterniond over(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(UniteSurfaces({a, Square({over, {0.5, 0, 0}}, 1.0)}, {}).size(), 2u);  // the other side
}

TEST(UniteSurfaces, JoinsBarsThatCross) {
  PlanarSurface bar = Square(At(0, 0, 0), 1.0), other = bar;
  bar.outlines = {{{{-2, -0.1}, {2, -0.1}, {2, 0.1}, {-2, 0.1}}, {}}};
  other.outlines = {{{{-0.1, -2}, {0.1, -2}, {0.1, 2}, {-0.1, 2}}, {}}};
  UniteOptions overlapping;
  overlapping.max_gap = 0.0;
  bar.covariance.setZero();
  other.covariance.setZero();
  const auto united = UniteSurfaces({bar, other}, overlapping);
  ASSERT_EQ(united.size(), 1u);
  EXPECT_NEAR(Area(united[0]), 1.56, 1e-3);
  EXPECT_TRUE(IsFinite(united[0].T_frame_plane));
}

TEST(UniteSurfaces, WeighsThePlanesAndUnitesTheOutlines) {
  const PlanarSurface a = Square(At(0, 0, 0), 1.0, 300), b = Square(At(0.5, 0, 0.008), 1.0, 100);
  const Pose3 T{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())),
                {4, 5, 6}};
  for (const auto& surfaces : {UniteSurfaces({a, b}, {}), UniteSurfaces({b, a}, {})}) {
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_NEAR(Area(surfaces[0]), 1.5, 1e-3);
    EXPECT_EQ(surfaces[0].points, 400u);
    EXPECT_GT(surfaces[0].T_frame_plane.translation.z(), 0.0);
    EXPECT_LT(surfaces[0].T_frame_plane.translation.z(), 0.004);
  }
  const auto moved = UniteSurfaces({Transformed(T, a), Transformed(T, b)}, {});
  ASSERT_EQ(moved.size(), 1u);
  const Pose3 expected = T * UniteSurfaces({a, b}, {})[0].T_frame_plane;
  EXPECT_LT(TranslationDistance(moved[0].T_frame_plane, expected), 1e-9);
}

TEST(UniteSurfaces, GoesOnFromWhatHasGrown) {
  std::vector<PlanarSurface> row;
  for (const int i : {0, 3, 1, 4, 2}) row.push_back(Square(At(i, 0, 0), 1.0, 100));
  const auto united = UniteSurfaces(row, {});
  ASSERT_EQ(united.size(), 1u);
  EXPECT_NEAR(Area(united[0]), 5.0, 1e-3);
}

}  // namespace
}  // namespace ariadne::slam
