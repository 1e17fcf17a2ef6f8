#include "slam/scan/scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/scan/simulated_scan.h"

namespace ariadne::slam {
namespace {

constexpr double kTurn = 1.0 / 75.0;  // 13.33 ms

TEST(BeamDirection, SweepsFromRightOverAheadToLeft) {
  const ScannerModel scanner = ScannerWithTurns(1);
  EXPECT_THAT(BeamDirection(scanner, 0, 0.0), NearMatrix(Eigen::Vector3d(0.0, -1.0, 0.0), 1e-15));
  EXPECT_THAT(BeamDirection(scanner, 90, 0.0), NearMatrix(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-15));
  EXPECT_THAT(BeamDirection(scanner, 180, 0.0), NearMatrix(Eigen::Vector3d(0.0, 1.0, 0.0), 1e-15));
}

TEST(BeamDirection, LooksUpWithPositivePitch) {
  const ScannerModel scanner = ScannerWithTurns(1);
  EXPECT_THAT(BeamDirection(scanner, 90, RadFromDeg(90.0)),
              NearMatrix(Eigen::Vector3d(0.0, 0.0, 1.0), 1e-15));
  EXPECT_THAT(BeamDirection(scanner, 90, RadFromDeg(-30.0)),
              NearMatrix(Eigen::Vector3d(std::numbers::sqrt3 / 2.0, 0.0, -0.5), 1e-15));
}

TEST(BeamDirection, IsTheTurnedSlicePlane) {
  for (const int turns : {1, 2, 4}) {
    const ScannerModel scanner = ScannerWithTurns(turns);
    for (std::size_t beam = 0; beam < BeamsOf(scanner); beam += 7) {
      for (const double pitch : {-1.0, -0.1, 0.0, 0.5, 1.5}) {
        const double angle = RadFromDeg(static_cast<double>(beam) / turns);
        EXPECT_THAT(BeamDirection(scanner, beam, pitch),
                    NearMatrix(DirectionByRotation(angle, pitch), 2e-15));
      }
    }
  }
}

TEST(BeamDirection, BeginsAtTheFirstAngle) {
  const ScannerModel hundred_degrees{RadFromDeg(40.0), RadFromDeg(0.25), 1};
  EXPECT_THAT(BeamDirection(hundred_degrees, 0, 0.0),
              NearMatrix(DirectionByRotation(RadFromDeg(40.0), 0.0), 1e-15));
  EXPECT_THAT(BeamDirection(hundred_degrees, 200, 0.0), NearMatrix(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-15));
}

TEST(BeamTime, OfOneTurnIsTheAngleOfTheMirror) {
  const ScannerModel scanner = ScannerWithTurns(1);
  EXPECT_EQ(BeamsOf(scanner), 181u);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 0), 0.0);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 90), kTurn / 4.0);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 180), kTurn / 2.0);
}

TEST(BeamTime, OfHalfDegreesIsInterleavedFromTwoTurns) {
  const ScannerModel scanner = ScannerWithTurns(2);
  EXPECT_EQ(BeamsOf(scanner), 361u);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 1), kTurn * (1.0 + 0.5 / 360.0));
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 2), kTurn / 360.0);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 359), kTurn * (1.0 + 179.5 / 360.0));
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 360), kTurn / 2.0);
}

TEST(BeamTime, OfQuarterDegreesIsInterleavedFromFourTurns) {
  const ScannerModel scanner = ScannerWithTurns(4);
  EXPECT_EQ(BeamsOf(scanner), 721u);
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 3), kTurn * (3.0 + 0.75 / 360.0));
  EXPECT_DOUBLE_EQ(BeamTime(scanner, 4), kTurn / 360.0);
  std::vector<int> beams_of_turn(4, 0);
  for (std::size_t beam = 0; beam < 721; ++beam) {
    ++beams_of_turn.at(static_cast<std::size_t>(BeamTime(scanner, beam) / kTurn));
  }
  EXPECT_THAT(beams_of_turn, testing::ElementsAre(181, 180, 180, 180));  // spec 9.2
}

TEST(BeamTime, CountsFromAngleZeroForANarrowSweep) {
  const ScannerModel hundred_degrees{RadFromDeg(40.0), RadFromDeg(1.0), 1};
  EXPECT_DOUBLE_EQ(BeamTime(hundred_degrees, 0), kTurn * 40.0 / 360.0);
}

TEST(Scan, OfThePaperLasts3_4Seconds) {
  const Scan scan = ScanOfRoom(1, 256, 120.0 / 256.0);
  EXPECT_NEAR(scan.sweeps.back().stamp + kTurn, 3.41, 0.005);
  EXPECT_EQ(ToPointCloud(scan).size(), 46'336u);
}

TEST(ToPointCloud, PutsAReturnWhereTheBeamLooks) {
  Scan scan = ScanWith({std::vector<float>(181, 2.0F)}, {{}});
  scan.sweeps[0].pitch = RadFromDeg(30.0);
  const PointCloud cloud = ToPointCloud(scan);
  EXPECT_THAT(cloud.positions.at(0), NearMatrix(Eigen::Vector3d(0.0, -2.0, 0.0), 1e-15));
  EXPECT_THAT(cloud.positions.at(90), NearMatrix(Eigen::Vector3d(std::numbers::sqrt3, 0.0, 1.0), 1e-15));
  EXPECT_THAT(cloud.positions.at(180), NearMatrix(Eigen::Vector3d(0.0, 2.0, 0.0), 1e-15));
}

TEST(ToPointCloud, TiltsOnByHalfAStepWhileTheMirrorSweeps) {
  const Scan scan = ScanOfRoom(1, 256, 120.0 / 256.0);
  const double step = scan.sweeps[1].pitch - scan.sweeps[0].pitch;
  EXPECT_NEAR(DegFromRad(step), 0.47, 0.002);
  const PointCloud cloud = ToPointCloud(scan);
  const auto pitch = [&](std::size_t i) {
    return std::atan2(cloud.positions[i].z(), cloud.positions[i].x());
  };
  EXPECT_NEAR(pitch(179) - pitch(1), step * 178.0 / 360.0, 1e-9);
  EXPECT_NEAR(pitch(181 + 90) - pitch(90), step, 1e-9);
}

TEST(ToPointCloud, LeavesTheWallsOfTheRoomFlat) {
  for (const int turns : {1, 2, 4}) {
    for (const Eigen::Vector3d& p : ToPointCloud(ScanOfRoom(turns, 16)).positions) {
      const double to_a_wall =
          std::min({std::abs(p.x() - 6.0), std::abs(p.x() + 2.0), std::abs(p.y() - 2.5),
                    std::abs(p.y() + 1.5), std::abs(p.z() - 2.0), std::abs(p.z() + 0.5)});
      EXPECT_LE(to_a_wall, 1e-6) << "more than the rounding of ranges to float";
    }
  }
}

TEST(ToPointCloud, SkipsBeamsWithoutReturn) {
  const float nan = LaserSweep::kNoReturn;
  const float infinity = std::numeric_limits<float>::infinity();
  const PointCloud cloud =
      ToPointCloud(ScanWith({{1.0F, nan, 3.0F}, {nan, nan, nan}, {infinity, 5.0F, nan}},
                            {{10.0F, 20.0F, 30.0F}, {0.0F, 0.0F, 0.0F}, {40.0F, 50.0F, 60.0F}}));
  ASSERT_EQ(cloud.size(), 3u);
  EXPECT_NEAR(cloud.positions[1].norm(), 3.0, 1e-15);
  EXPECT_NEAR(cloud.positions[2].norm(), 5.0, 1e-15);
  EXPECT_THAT(cloud.reflectance, testing::ElementsAre(10.0F, 30.0F, 50.0F));
  EXPECT_THAT(cloud.slice_begin, testing::ElementsAre(0, 2, 2));
}

TEST(ToPointCloud, DropsReflectanceThatOnlySomeSweepsHave) {
  const std::vector<std::vector<float>> ranges = {{1.0F, 2.0F}, {3.0F, 4.0F}};
  EXPECT_THAT(ToPointCloud(ScanWith(ranges, {{10.0F, 20.0F}, {}})).reflectance, testing::IsEmpty());
  EXPECT_THAT(ToPointCloud(ScanWith(ranges, {{}, {10.0F, 20.0F}})).reflectance, testing::IsEmpty());
}

TEST(ToPointCloud, OfAnEmptyScanIsEmpty) {
  EXPECT_TRUE(ToPointCloud({}).empty());
  EXPECT_FALSE(ToPointCloud({}).organized());
}

}  // namespace
}  // namespace ariadne::slam
