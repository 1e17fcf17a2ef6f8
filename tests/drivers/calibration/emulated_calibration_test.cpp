// Calibration on scans as the drivers of the real robot take them: centimetres, steps of the servo,
// furniture.
#include <gtest/gtest.h>

#include "drivers/calibration/calibrate_scanner.h"
#include "slam/geometry/angles.h"
#include "tests/drivers/emulated/robot/robot_bench.h"

namespace ariadne::drivers {
namespace {

TEST(CalibrateScanner, FindsTheZeroOfTheServoAndTheMirrorOnAnEmulatedRobot) {
  RobotBenchOptions options = Exact();
  options.emulated.level = 181.0;
  options.ais.mirror_forward = 0.03;
  options.ais.mirror_up = 0.02;
  RobotBench bench(FurnishedRoom(), options);
  bench.robot->Connect();
  const std::vector<slam::Scan> scans{bench.robot->TakeScan()};
  const ScannerCalibration found = CalibrateScanner(scans, {});
  EXPECT_NEAR(found.mounting.pitch, slam::RadFromDeg(-1.0), 0.002);
  EXPECT_NEAR(found.mounting.roll, 0.0, 0.002);
  EXPECT_NEAR(found.mounting.height, 0.95, 0.006);
  EXPECT_NEAR(found.mounting.mirror_forward, 0.03, 0.008);
  EXPECT_NEAR(found.mounting.mirror_up, 0.02, 0.008);
}

}  // namespace
}  // namespace ariadne::drivers
