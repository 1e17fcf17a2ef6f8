#include "drivers/calibration/calibrate_scanner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/drivers/calibration/measured_room.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

TEST(EndOf, IsDerivedRight) {
  const MeasuredBeam beam{0.7, -0.4, 3.2};
  const ScannerMounting mounting = CrookedMounting();
  const BeamEnd end = EndOf(beam, mounting);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < ScannerMounting::kSize; ++i) {
    ScannerMounting::Vector more = mounting.ToVector(), less = more;
    more[i] += kStep;
    less[i] -= kStep;
    const Eigen::Vector3d slope =
        (EndOf(beam, ScannerMounting::Of(more)).p_base - EndOf(beam, ScannerMounting::Of(less)).p_base) /
        (2.0 * kStep);
    EXPECT_LT((slope - end.derivative.col(i)).norm(), 1e-8) << i;
  }
}

/// Without offsets it is where a Scan has its points.
TEST(EndOf, IsThePointOfTheScan) {
  const slam::ScannerModel scanner{0.0, 0.1};
  ScannerMounting mounting;
  mounting.height = 0.5;
  const Eigen::Vector3d p_laser = slam::BeamDirection(scanner, 7, -0.3) * 2.0;
  EXPECT_LT((EndOf({0.7, -0.3, 2.0}, mounting).p_base - p_laser - Eigen::Vector3d(0, 0, 0.5)).norm(),
            1e-12);
}

TEST(CalibrateScanner, FindsACrookedMountingExactlyWithoutNoise) {
  RandomStream stream = NamedStream(1, "room");
  RoomScanOptions options;
  options.truth = CrookedMounting();
  options.range_noise = options.pitch_noise = 0.0;
  CalibrateScannerOptions wide;
  wide.range_offset_sigma = 1.0;
  const ScannerCalibration result = CalibrateOnPlanes(ScanRoom(options, stream).planes, {}, wide);
  EXPECT_LT((result.mounting.ToVector() - options.truth.ToVector()).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_EQ(result.floors, 1U);
  EXPECT_EQ(result.walls, 3U);  // the fourth is behind the robot
}

/// From a scan as a robot takes it, with nothing known but where the scanner should be.
TEST(CalibrateScanner, FindsItFromScans) {
  RandomStream stream = NamedStream(1, "room");
  RoomScanOptions options;
  options.truth = CrookedMounting();
  options.slices = 128;
  options.beams = 181;
  const std::vector<slam::Scan> scans{ScanRoom(options, stream).scan};
  const ScannerCalibration result = CalibrateScanner(scans, {});
  const ScannerMounting::Vector error = result.mounting.ToVector() - options.truth.ToVector();
  for (int i = 0; i < ScannerMounting::kSize; ++i)
    EXPECT_LT(std::abs(error[i]), 4.0 * std::sqrt(result.covariance(i, i)) + 1e-4) << i;
  EXPECT_LT(std::abs(error[0]), 0.002);
  EXPECT_LT(std::abs(error[2]), 0.005);
  EXPECT_GT(result.floors, 0U);
  EXPECT_GE(result.walls, 3U);
  EXPECT_LT(result.rms, 0.015);
}

/// What stands around and belongs to nothing does not count.
TEST(CalibrateScanner, PassesOverOutliers) {
  RandomStream stream = NamedStream(2, "room");
  RoomScanOptions options;
  options.truth = CrookedMounting();
  RoomScan room = ScanRoom(options, stream);
  for (CalibrationPlane& plane : room.planes) {
    for (MeasuredBeam& beam : plane.beams) {
      if (DrawUniform(stream, 0.0, 1.0) < 0.1) beam.range *= 0.9;
    }
  }
  const ScannerCalibration result = CalibrateOnPlanes(room.planes, {});
  EXPECT_LT((result.mounting.ToVector() - options.truth.ToVector()).cwiseAbs().head<5>().maxCoeff(), 0.008);
}

/// Seen from low to high, a floor alone tells less; from one pitch hardly anything.
TEST(CalibrateScanner, RefusesWhatCannotBeTold) {
  RandomStream stream = NamedStream(3, "room");
  RoomScanOptions options;
  options.lowest = -0.62;
  options.highest = -0.55;
  EXPECT_THAT(ErrorOf([&] { CalibrateOnPlanes(ScanRoom(options, stream).planes, {}); }),
              HasSubstr("do not tell"));
  options.lowest = 0.3;
  options.highest = 0.9;
  RoomScan room = ScanRoom(options, stream);
  room.planes.erase(room.planes.begin());
  EXPECT_THAT(ErrorOf([&] { CalibrateOnPlanes(room.planes, {}); }), HasSubstr("no floor is seen"));
  EXPECT_THAT(ErrorOf([&] { CalibrateScanner({}, {}); }), HasSubstr("no scans"));
}

TEST(CalibrateScanner, RefusesWhatIsNoMounting) {
  RandomStream stream = NamedStream(4, "room");
  RoomScanOptions options;
  options.truth.height = 1.3;
  EXPECT_THAT(ErrorOf([&] { CalibrateOnPlanes(ScanRoom(options, stream).planes, {}); }),
              HasSubstr("a height of 1."));
  options.truth.height = 0.95;
  options.truth.pitch = 0.2;
  EXPECT_THAT(ErrorOf([&] { CalibrateOnPlanes(ScanRoom(options, stream).planes, {}); }),
              HasSubstr("pitch"));
  options.truth.pitch = 0.0;
  options.range_noise = 0.06;
  CalibrateScannerOptions patient;
  patient.max_sigma_angle = patient.max_sigma_length = 1.0;
  EXPECT_THAT(ErrorOf([&] { CalibrateOnPlanes(ScanRoom(options, stream).planes, {}, patient); }),
              HasSubstr("did something move"));
}

}  // namespace
}  // namespace ariadne::drivers
