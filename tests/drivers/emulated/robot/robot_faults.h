#pragma once

#include <gtest/gtest.h>

#include <string>

#include "drivers/emulated/line_fault.h"
#include "drivers/simulated/surface_distance.h"
#include "tests/drivers/emulated/robot/robot_bench.h"

namespace ariadne::drivers {

/// What became of 3D scans whose lines were disturbed.
struct ScansWithFaults {
  int faults = 0;
  int scans = 0;      // that were taken, right in all their points
  int repeated = 0;   // of them, because slices were missing
  int sentences = 0;  // instead of a scan
};

/// Whether all points of a scan lie on what is there, 2 cm at the most from it: a wrong range, a range of
/// another beam and a slice of another time do not.
inline testing::AssertionResult IsRight(const slam::Scan& scan, const slam::Pose3& T_map_laser,
                                        const SurfaceDistance& surface) {
  for (const Eigen::Vector3d& p_laser : slam::ToPointCloud(scan).positions) {
    const double error = surface.Closest(T_map_laser * p_laser).distance;
    if (error > 0.02) return testing::AssertionFailure() << p_laser.transpose() << " is wrong by " << error;
  }
  return testing::AssertionSuccess();
}

/// Takes a scan; returns the sentence instead, if there is one.
inline std::string TakeScan(HardwareRobot& robot, slam::Scan& scan) {
  try {
    scan = robot.TakeScan();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// Injects up to 20 faults of all kinds into the time of a scan, on all lines. Returns whether one of them
/// leaves a device of a kind that forgets what it was told without power.
inline bool DisturbScan(const RobotBench& bench, RandomStream& stream, ScansWithFaults& count) {
  bool forgets = false;
  const double now = bench.scanner->Now();
  const int faults = 1 + static_cast<int>(stream() % 20);
  for (int i = 0; i < faults; ++i, ++count.faults) {
    const std::array<EmulatedLine*, 3> lines{bench.scanner, bench.servo, bench.motors};
    EmulatedLine* line = lines[stream() % lines.size()];
    const LineFault fault = DrawFault(stream, now, now + 3.0);
    line->Inject(fault);
    forgets = forgets || (fault.kind == LineFault::Kind::kPowerLoss && line != bench.scanner);
  }
  return forgets;
}

/// At least so many faults on whole scans: each scan is right, or there is a sentence instead and the
/// wheels stand. Where no device forgot its settings the same robot scans again when the faults are over.
inline ScansWithFaults ScanWithFaults(std::uint64_t seed, int faults) {
  ScansWithFaults count;
  const World world = FurnishedRoom();
  const SurfaceDistance surface(world);
  RandomStream stream = NamedStream(seed, "robot faults");
  while (count.faults < faults && !testing::Test::HasFailure()) {
    RobotBench bench(FurnishedRoom());
    bench.robot->Connect();
    for (bool forgot = false; !forgot && count.faults < faults && !testing::Test::HasFailure();) {
      forgot = DisturbScan(bench, stream, count);
      slam::Scan scan;
      const std::string error = TakeScan(*bench.robot, scan);
      EXPECT_EQ(bench.device.motors().speeds(), (std::array<double, 2>{0.0, 0.0})) << error;
      ++(error.empty() ? count.scans : count.sentences);
      EXPECT_TRUE(IsRight(scan, bench.robot->T_base_laser(), surface))
          << "seed " << seed << ", fault " << count.faults;
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
      if (error.empty() || forgot) continue;
      bench.motors->Read(bench.motors->Now() + 5.0);
      EXPECT_EQ(TakeScan(*bench.robot, scan), "") << "after " << error;
      EXPECT_TRUE(IsRight(scan, bench.robot->T_base_laser(), surface));
    }
    count.repeated += bench.robot->repeated_scans();
  }
  return count;
}

}  // namespace ariadne::drivers
