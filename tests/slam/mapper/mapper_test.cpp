#include "slam/mapper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"
#include "slam/geometry/angles.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/error_of.h"
#include "tests/support/office_scans.h"

namespace ariadne::slam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Pose3 Truth(std::size_t stop) { return LaserAt(drivers::OfficeTour()[stop]); }

/// The scan at a stop as odometry believes it: 10 cm and 3 degrees farther off at each stop.
PosedCloud ScanByOdometry(std::size_t stop) {
  Pose3 T_odom_laser = Truth(0);
  for (std::size_t i = 1; i <= stop; ++i) {
    const Pose3 slip{ExpSo3({0.0, 0.0, RadFromDeg(3.0)}), {0.1, 0.0, 0.0}};
    T_odom_laser = T_odom_laser * (Truth(i - 1).Inverse() * Truth(i)) * slip;
  }
  return {"scan" + std::to_string(stop), ScanOffice(Truth(stop), stop), T_odom_laser};
}

constexpr std::size_t kScans = 4;

/// The first scans of the tour, added one by one.
Mapper MapTour(const MapperOptions& options, std::size_t scans = kScans) {
  Mapper mapper(options);
  for (std::size_t i = 0; i < scans; ++i) {
    const MatchResult result = mapper.AddScan(ScanByOdometry(i));
    EXPECT_TRUE(result.registered) << i << ": " << result.message;
  }
  return mapper;
}

class MapperBy : public testing::TestWithParam<MatchMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, MapperBy,
                         testing::Values(MatchMethod::kPairwise, MatchMethod::kMetascan,
                                         MatchMethod::kSimultaneous, MatchMethod::kGraph,
                                         MatchMethod::kJoint),
                         [](const auto& method) { return std::string(NameOf(method.param)); });

TEST_P(MapperBy, BringsTheScansOfTheOfficeToTheirPlaces) {
  MapperOptions options;
  options.registration.method = GetParam();
  const Mapper mapper = MapTour(options);
  ASSERT_EQ(mapper.scans().size(), kScans);
  for (std::size_t i = 1; i < kScans; ++i) {
    const MapScan& scan = mapper.scans()[i];
    EXPECT_EQ(scan.name, "scan" + std::to_string(i));
    EXPECT_LT(TranslationDistance(scan.T_map_laser, Truth(i)), 0.02) << i;
    EXPECT_LT(RotationDistance(scan.T_map_laser, Truth(i)), RadFromDeg(0.5)) << i;
    EXPECT_GT(TranslationDistance(ScanByOdometry(i).T_map_laser, Truth(i)), 0.09) << "odometry was off";
  }
}

TEST(Mapper, TakesTheFirstScanAsItsMaster) {
  Mapper mapper{MapperOptions()};
  const PosedCloud first = ScanByOdometry(0);
  const MatchResult result = mapper.AddScan(first);
  EXPECT_TRUE(result.registered);
  EXPECT_THAT(result.message, StartsWith("master"));
  EXPECT_THAT(result.steps, IsEmpty());
  mapper.AddScan(ScanByOdometry(1));
  EXPECT_THAT(mapper.scans()[0].T_map_laser, NearPose(first.T_map_laser, 0.0)) << "it stays where it is";
}

TEST(Mapper, UsesOnlyTheChangeOfTheOdometry) {
  const Mapper mapper = MapTour({}, 3);
  Mapper elsewhere{MapperOptions()};
  const Pose3 T_other_odom{ExpSo3({0.0, 0.0, 2.0}), {50.0, -7.0, 0.0}};
  for (std::size_t i = 0; i < 3; ++i) {
    PosedCloud scan = ScanByOdometry(i);
    scan.T_map_laser = T_other_odom * scan.T_map_laser;
    elsewhere.AddScan(scan);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_THAT(elsewhere.scans()[i].T_map_laser,
                NearPose(T_other_odom * mapper.scans()[i].T_map_laser, 1e-5));
  }
}

TEST(Mapper, GuessesFromTheCorrectedPoseOfTheScanBefore) {
  Mapper mapper = MapTour({}, 2);
  const Pose3 last = mapper.scans().back().T_map_laser;
  const PosedCloud before = ScanByOdometry(1), next = ScanByOdometry(2);
  const MatchResult result = mapper.AddScan(next);
  EXPECT_THAT(result.T_map_laser_guess,
              NearPose(last * before.T_map_laser.Inverse() * next.T_map_laser, 1e-12));
}

TEST_P(MapperBy, GoesOnFromRestoredScansAsIfItHadNeverStopped) {
  MapperOptions options;
  options.registration.method = GetParam();
  Mapper whole = MapTour(options);
  const Mapper killed = MapTour(options, 2);
  Mapper resumed(options);
  for (std::size_t i = 0; i < 2; ++i) {
    const MapScan& scan = killed.scans()[i];
    resumed.RestoreScan(ScanByOdometry(i), scan.T_map_laser, scan.registered);
  }
  resumed.RestoreGraph(killed.graph());
  for (std::size_t i = 2; i < kScans; ++i) resumed.AddScan(ScanByOdometry(i));
  whole.Finish();
  resumed.Finish();
  for (std::size_t i = 0; i < kScans; ++i) {
    EXPECT_THAT(resumed.scans()[i].T_map_laser, NearPose(whole.scans()[i].T_map_laser, 0.0)) << i;
    EXPECT_EQ(resumed.scans()[i].registered, whole.scans()[i].registered);
  }
}

TEST_P(MapperBy, DoesNotDependOnTheNumberOfThreads) {
  MapperOptions options;
  options.registration.method = GetParam();
  Mapper one = MapTour(options, 3);
  options.icp.threads = 2;
  Mapper two = MapTour(options, 3);
  one.Finish();
  two.Finish();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_THAT(two.scans()[i].T_map_laser, NearPose(one.scans()[i].T_map_laser, 0.0)) << i;
  }
}

TEST(Mapper, KeepsOnlyReducedPointsWithinRange) {
  MapperOptions options;
  options.scan = {.min_range = 1.0, .max_range = 3.0};
  options.reduce.voxel_size = 0.4;
  Mapper mapper(options);
  const PosedCloud scan = ScanByOdometry(0);
  mapper.AddScan(scan);
  const PointCloud& points = mapper.scans()[0].points_laser;
  const std::size_t in_range = WithinRange(scan.cloud_laser, 1.0, 3.0).size();
  ASSERT_LT(in_range, scan.cloud_laser.size());
  EXPECT_LT(points.size(), in_range / 4) << "of points 10 cm apart";
  EXPECT_GT(points.size(), 50U);
  for (const Eigen::Vector3d& p : points.positions) {
    EXPECT_GT(p.norm(), 0.8) << "means of a voxel lie between its points";
    EXPECT_LT(p.norm(), 3.0);
  }
}

TEST(Mapper, MatchesTheEdgePointsOfSlices) {
  MapperOptions options;
  options.registration.points = MatchPoints::kEdges;
  options.icp.metric = Metric::kPointToPoint;
  Mapper mapper(options);
  const drivers::RayScene scene(drivers::LoadWorld("builtin:robobench", {}));
  Pose3 T_map_base = ToPose3(scene.world().T_map_start);
  for (const std::uint64_t stop : {0, 1}) {
    const Scan scan = drivers::TakeAisScan(scene, T_map_base, 0.0, {}, 1, stop, Parallel(1));
    const PointCloud cloud_laser = ToPointCloud(scan);
    EXPECT_TRUE(mapper.AddScan({"scan", cloud_laser, Pose3()}).registered) << "as if it had not moved";
    EXPECT_LT(mapper.scans().back().points_laser.size(), cloud_laser.size() / 5);
    if (stop == 0) T_map_base.translation.x() += 0.1;
  }
  const Eigen::Vector3d moved = mapper.scans()[1].T_map_laser.translation;
  EXPECT_LT((moved - Eigen::Vector3d(0.1, 0.0, 0.0)).norm(), 0.04) << moved.transpose();
}

TEST(Mapper, RefusesEdgePointsOfAScanWithoutSlices) {
  MapperOptions options;
  options.registration.points = MatchPoints::kEdges;
  PosedCloud scan = ScanByOdometry(0);
  scan.cloud_laser.slice_begin.clear();
  EXPECT_THAT(ErrorOf([&] { Mapper(options).AddScan(scan); }),
              StartsWith("scan0: registration.points=edges needs slices"));
}

TEST(Mapper, RefusesAScanWithoutAPointInRange) {
  Mapper mapper = MapTour({}, 1);
  const PosedCloud far{"scan7", {{{90.0, 0.0, 0.0}, {0.0, 0.1, 0.0}}, {}, {}, {}}, Pose3()};
  EXPECT_EQ(ErrorOf([&] { mapper.AddScan(far); }),
            "scan7: none of its 2 points is between scan.min_range=0.5 and scan.max_range=32 m");
  EXPECT_EQ(mapper.scans().size(), 1U) << "it can go on without it";
  EXPECT_TRUE(mapper.AddScan(ScanByOdometry(1)).registered);
}

TEST(Mapper, KeepsAScanThatItCannotRegisterAndGoesOn) {
  Mapper mapper = MapTour({}, 2);
  PosedCloud lost = ScanByOdometry(2);
  lost.T_map_laser.translation.x() += 500.0;
  EXPECT_FALSE(mapper.AddScan(lost).registered);
  EXPECT_FALSE(mapper.scans().back().registered);
  PosedCloud next = ScanByOdometry(3);
  next.T_map_laser.translation.x() += 1.0;  // the odometry has jumped back
  mapper.AddScan(next);
  EXPECT_EQ(mapper.scans().size(), 4U);
}

TEST(Mapper, RefusesOptionsOutOfRange) {
  MapperOptions options;
  options.icp.trim = 7.0;
  EXPECT_THAT(ErrorOf([&] { Mapper mapper(options); }), HasSubstr("icp.trim is 7"));
}

}  // namespace
}  // namespace ariadne::slam
