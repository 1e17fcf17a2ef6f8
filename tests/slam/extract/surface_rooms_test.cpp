#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "experiments/metrics/statistics.h"
#include "experiments/metrics/surface_detection.h"
#include "slam/extract/extract_surfaces.h"
#include "slam/geometry/angles.h"
#include "tests/slam/extract/simulated_slice.h"

// Surfaces of random rooms with all errors of the scanner, against the patches that its beams meet.
namespace ariadne::slam {
namespace {

using experiments::Median;
using experiments::SurfaceScore;

constexpr std::uint64_t kSeeds = 50;

/// A quarter of a scan at the full scan's step of 0.47 deg, from the floor 2 m ahead to above the horizon.
drivers::AisScannerOptions QuarterScan() {
  drivers::AisScannerOptions options;
  options.slices = 64;
  options.lowest_pitch = RadFromDeg(-25.0);
  options.highest_pitch = RadFromDeg(5.0);
  return options;
}

struct SimulatedScan {
  PointCloud cloud_laser;
  std::vector<experiments::TruePatch> patches;
};

SimulatedScan SimulateScan(std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "surfaces");
  const Room room = DrawRoom(stream);
  const Eigen::Vector3d viewpoint_map = DrawViewpoint(stream, room);
  const drivers::AisScannerOptions options = QuarterScan();
  Pose3 T_map_base = ToPose3({DrawUniform(stream, -3.0, 3.0), Eigen::Vector2d::Zero()});
  T_map_base.translation =
      viewpoint_map - T_map_base * drivers::AisMounting(options).T_base_laser.translation;
  const drivers::RayScene scene = SceneOf(room);
  const Scan scan = drivers::TakeAisScan(scene, T_map_base, 0.0, options, seed, 0, Parallel(1));
  return {ToPointCloud(scan), experiments::VisiblePatches(scene, T_map_base, options)};
}

const std::vector<SimulatedScan>& Scans() {
  static const std::vector<SimulatedScan> kScans = [] {
    std::vector<SimulatedScan> scans;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) scans.push_back(SimulateScan(seed));
    return scans;
  }();
  return kScans;
}

class SurfaceRooms : public testing::TestWithParam<SurfaceMethod> {
 protected:
  static std::vector<PlanarSurface> Extract(const PointCloud& cloud_laser) {
    ExtractSurfacesOptions options;
    options.method = GetParam();
    return ExtractSurfaces(cloud_laser, options);
  }
};

TEST_P(SurfaceRooms, AreFoundWithFewErrors) {
  SurfaceScore score;
  for (const SimulatedScan& scan : Scans()) {
    score += experiments::ScoreSurfaces(Extract(scan.cloud_laser), scan.patches, {});
  }
  const double pieces = std::accumulate(score.pieces.begin(), score.pieces.end(), 0.0) /
                        static_cast<double>(score.pieces.size());
  RecordProperty("patches", std::to_string(score.patches));
  RecordProperty("recall", std::to_string(score.Recall()));
  RecordProperty("precision", std::to_string(score.Precision()));
  RecordProperty("median_angle_deg", std::to_string(DegFromRad(Median(score.angles))));
  RecordProperty("median_offset_m", std::to_string(Median(score.offsets)));
  RecordProperty("pieces_per_patch", std::to_string(pieces));
  EXPECT_GT(score.patches, 150u);
  EXPECT_GE(score.Recall(), 0.95);
  EXPECT_GE(score.Precision(), 0.95);
  EXPECT_LE(Median(score.angles), RadFromDeg(0.5));
  EXPECT_LE(Median(score.offsets), 0.01);
  EXPECT_LE(pieces, 1.2);
}

TEST_P(SurfaceRooms, FaceTheScannerWithLevelAxes) {
  for (const PlanarSurface& surface : Extract(Scans()[3].cloud_laser)) {
    EXPECT_LT(PlaneOf(surface).offset, 0.0);
    EXPECT_NEAR((surface.T_frame_plane.rotation * Eigen::Vector3d::UnitX()).z(), 0.0, 0.05);
    EXPECT_LT(surface.rms, 0.02);
    EXPECT_GT(surface.covariance.ldlt().vectorD().minCoeff(), 0.0);
    for (const Polygon2& outline : surface.outlines) EXPECT_GT(SignedArea(outline.outer), 0.0);
  }
}

TEST_P(SurfaceRooms, GiveTheSameBytesAgain) {
  const auto first = Extract(Scans()[5].cloud_laser), again = Extract(Scans()[5].cloud_laser);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].T_frame_plane.Matrix(), again[i].T_frame_plane.Matrix());
    EXPECT_EQ(OutlinePoints(first[i]), OutlinePoints(again[i]));
  }
}

/// The patch as a surface without errors, between these shares of its extent along x.
PlanarSurface SurfaceOf(const experiments::TruePatch& patch, double from, double to) {
  PlanarSurface surface;
  surface.T_frame_plane = PlaneFrame(patch.points_laser.front(), patch.plane_laser.normal);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : patch.points_laser) box.extend(InPlane(surface, p));
  const double left = box.min().x() - 0.01 + from * (box.sizes().x() + 0.02);
  const double right = box.min().x() - 0.01 + to * (box.sizes().x() + 0.02);
  const double bottom = box.min().y() - 0.01, top = box.max().y() + 0.01;
  surface.outlines = {{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}}};
  return surface;
}

TEST(ScoreSurfaces, TellsFoundFromMissedAndWholeFromCut) {
  const auto& patches = Scans()[8].patches;
  const auto largest = std::ranges::max_element(patches, {}, &experiments::TruePatch::area);
  const std::vector<experiments::TruePatch> patch{*largest};
  const std::vector<PlanarSurface> whole{SurfaceOf(*largest, 0.0, 1.0)};
  const std::vector<PlanarSurface> cut{SurfaceOf(*largest, 0.0, 0.7), SurfaceOf(*largest, 0.7, 1.0)};
  const SurfaceScore found = experiments::ScoreSurfaces(whole, patch, {});
  EXPECT_EQ(found.Recall(), 1.0);
  EXPECT_NEAR(found.covers.at(0), 1.0, 1e-9);
  EXPECT_NEAR(found.offsets.at(0), 0.0, 1e-6);
  EXPECT_NEAR(found.angles.at(0), 0.0, 1e-6);
  EXPECT_EQ(found.pieces.at(0), 1.0);
  EXPECT_EQ(experiments::ScoreSurfaces(cut, patch, {}).pieces.at(0), 2.0);
  EXPECT_EQ(experiments::ScoreSurfaces({}, patch, {}).Recall(), 0.0);
  std::vector<PlanarSurface> away = whole;
  away[0].T_frame_plane.translation += 0.1 * largest->plane_laser.normal;
  const SurfaceScore missed = experiments::ScoreSurfaces(away, patch, {});
  EXPECT_EQ(missed.Recall(), 0.0);
  EXPECT_EQ(missed.Precision(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(, SurfaceRooms,
                         testing::Values(SurfaceMethod::kLines, SurfaceMethod::kRegionGrowing),
                         [](const auto& tested) { return std::string(NameOf(tested.param)); });

}  // namespace
}  // namespace ariadne::slam
