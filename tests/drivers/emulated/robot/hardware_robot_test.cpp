// The driver of the whole robot on emulated devices in one simulated world, in virtual time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/simulated/surface_distance.h"
#include "tests/drivers/emulated/robot/robot_bench.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

/// Of the returns of a scan to the surfaces of a world, ascending [m].
std::vector<double> ErrorsOf(const slam::Scan& scan, const slam::Pose3& T_map_laser, const World& world) {
  const SurfaceDistance surface(world);
  std::vector<double> errors;
  for (const Eigen::Vector3d& p_laser : slam::ToPointCloud(scan).positions)
    errors.push_back(surface.Closest(T_map_laser * p_laser).distance);
  std::sort(errors.begin(), errors.end());
  return errors;
}

TEST(HardwareRobot, ScansWhatIsThere) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  const slam::Scan scan = bench.robot->TakeScan();
  EXPECT_NEAR(static_cast<double>(scan.sweeps.size()), 128.0, 3.0);
  EXPECT_NEAR(scan.sweeps.front().pitch, slam::RadFromDeg(-55.0), 0.02);
  EXPECT_NEAR(scan.sweeps.back().pitch, slam::RadFromDeg(65.0), 0.03);
  const auto errors = ErrorsOf(scan, bench.robot->T_base_laser(), FurnishedRoom());
  ASSERT_GT(errors.size(), 120U * 170U);
  EXPECT_LT(errors[errors.size() / 2], 0.003);  // centimetres make 2.5 mm, head-on
  EXPECT_LT(errors.back(), 0.012);              // and steps of the servo
}

/// Each slice is of its own time, and of where the mount was then, not of where it was told to be.
TEST(HardwareRobot, KnowsWhereTheMountWas) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  const slam::Scan scan = bench.robot->TakeScan();
  for (std::size_t i = 1; i < scan.sweeps.size(); ++i) {
    const double turns = (scan.sweeps[i].stamp - scan.sweeps[i - 1].stamp) * 75.0;
    EXPECT_NEAR(turns, std::round(turns), 0.1);
  }
  EXPECT_NEAR(scan.sweeps[60].pitch_rate, slam::RadFromDeg(120.0) / 1.7067, 0.02);
}

/// Neither bytes that wait in an adapter nor the servo's steps turn a scan: 0.1 mrad is 1 mm at 10 m.
TEST(HardwareRobot, KnowsThePitchOfEachSlice) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  bench.Watch();
  const double start = bench.motors->Now() - bench.robot->Now();
  for (int scan = 0; scan < 4; ++scan) {
    bench.truths.clear();
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (const slam::LaserSweep& sweep : bench.robot->TakeScan().sweeps) {
      const auto truth = bench.TruthAt(start + sweep.stamp);
      EXPECT_NEAR(start + sweep.stamp, truth.stamp, 0.0001);
      sum += sweep.pitch - truth.pitch;
      squares += std::pow(sweep.pitch - truth.pitch, 2);
      count += 1.0;
    }
    EXPECT_NEAR(sum / count, 0.0, 5e-5);
    EXPECT_LT(std::sqrt(squares / count), 2e-4);
  }
}

TEST(HardwareRobot, SeesTheSameWhereItIsReversedAndSwapped) {
  RobotBenchOptions options = Exact();
  options.hardware.swapped = true;
  RobotBench bench(FurnishedRoom(), options);
  bench.robot->Connect();
  bench.DriveFor({0.0, 0.4}, 1.0);
  bench.Halt();
  EXPECT_LT(bench.device.base().T_map_base_true().angle, -0.2);  // the emulated motors are not swapped
  EXPECT_GT(bench.robot->State().odometry.T_odom_base.angle, 0.2);
}

TEST(HardwareRobot, KnowsWhereItHasDriven) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  for (int side = 0; side < 4; ++side) {
    bench.DriveFor({0.4, 0.0}, 2.0);
    bench.Halt();
    bench.DriveFor({0.0, 0.5}, std::numbers::pi);
    bench.Halt();
  }
  const slam::Pose2 odometry = bench.robot->State().odometry.T_odom_base;
  const slam::Pose2 truth = bench.device.base().T_map_base_true();
  EXPECT_LT((odometry.translation - truth.translation).norm(), 0.005);
  EXPECT_NEAR(odometry.angle, truth.angle, 0.002);
  EXPECT_NEAR(truth.angle, 0.0, 0.2);  // a square
  EXPECT_LT(truth.translation.norm(), 0.2);
}

/// What the encoders have counted is of when they were read, not of when somebody heard of it.
TEST(HardwareRobot, KnowsWhenItWasThere) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  for (int i = 0; i < 30; ++i) {
    bench.DriveFor({0.5, 0.0}, 0.05);
    const RobotState state = bench.robot->State();
    const auto& path = bench.device.base().path_true();
    const auto after = std::ranges::lower_bound(path, state.stamp, {}, &TruePose::time);
    ASSERT_NE(after, path.end());
    const double way = after->T_map_base.translation.x() - 0.5 * (after->time - state.stamp);
    if (i > 20) EXPECT_NEAR(state.odometry.T_odom_base.translation.x(), way, 0.0003);
  }
}

/// A sweep of a robot that drives towards a wall is of where it was when the sweep was taken.
TEST(HardwareRobot, LooksAheadWhileItDrives) {
  RobotBench bench(EmptyRoom({-4, -3, 0}, {4, 3, 2.7}));
  bench.robot->Connect();
  bench.DriveFor({0.5, 0.0}, 2.0);
  const slam::LaserSweep sweep = bench.robot->TakeSweep();
  const double age = bench.robot->Now() - sweep.stamp;
  EXPECT_LT(age, 0.06);
  const double ahead = 4.0 - 0.25 - bench.device.base().T_map_base_true().translation.x();
  EXPECT_NEAR(sweep.ranges[90], ahead + 0.5 * age, 0.012);
}

TEST(HardwareRobot, TakesAScanAgainWhereSomethingMoved) {
  World world = FurnishedRoom();
  Body walker = BoxBody("walker", {-0.15, -0.15, 0.0}, {0.15, 0.15, 1.8});
  walker.motion = {{4.0, 9.0}, {slam::ToPose3({0.0, {2.5, -2.5}}), slam::ToPose3({0.0, {2.5, 2.5}})}};
  world.bodies.push_back(walker);
  RobotBench bench(world);
  bench.robot->Connect();
  bench.robot->TakeScan();
  EXPECT_GE(bench.robot->repeated_scans(), 1);
  EXPECT_LE(bench.robot->repeated_scans(), 3);
}

/// The wheels are held by what they touch, and free again when the robot has left it.
TEST(HardwareRobot, NoticesThatSomethingHoldsTheWheels) {
  RobotBench bench(EmptyRoom({-4, -3, 0}, {1.0, 3, 2.7}));
  bench.robot->Connect();
  for (int i = 0; i < 100 && !bench.robot->State().blocked; ++i) bench.DriveFor({0.3, 0.0}, 0.1);
  EXPECT_TRUE(bench.robot->State().blocked);
  EXPECT_EQ(bench.device.base().collisions().size(), 1U);
  bench.DriveFor({}, 0.2);
  EXPECT_TRUE(bench.robot->State().blocked);
  bench.DriveFor({-0.2, 0.0}, 1.0);
  EXPECT_FALSE(bench.robot->State().blocked);
  EXPECT_LT(bench.robot->State().odometry.T_odom_base.translation.x(), 0.6);
}

/// Whoever drives has died: the board stops the wheels by itself.
TEST(HardwareRobot, StopsWhereNobodyCommandsIt) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  bench.DriveFor({0.3, 0.0}, 1.5);
  bench.robot->Drive({0.3, 0.0});
  const double told = bench.motors->Now();
  bench.motors->CatchUp(told + 0.15);
  EXPECT_GT(bench.device.motors().speeds()[0], 0.0);
  bench.motors->CatchUp(told + 0.2 + 0.1 + 0.01);  // the timeout, the rest of the command's own time
  EXPECT_EQ(bench.device.motors().speeds()[0], 0.0);
}

LineFault Fault(LineFault::Kind kind, double time, double duration) {
  LineFault fault;
  fault.kind = kind;
  fault.time = time;
  fault.duration = duration;
  return fault;
}

/// What ends a mission ends it with a sentence, and with wheels that stand.
TEST(HardwareRobot, StopsTheWheelsAndSaysWhatIsWrong) {
  const auto error_while_driving = [](EmulatedLine* RobotBench::*line, const LineFault& fault) {
    RobotBenchOptions options = Exact();
    options.hardware.scanner.recovery_time = 2.0;
    RobotBench bench(FurnishedRoom(), options);
    bench.robot->Connect();
    bench.DriveFor({0.2, 0.0}, 0.5);
    LineFault soon = fault;
    soon.time = bench.motors->Now() + 0.2;
    (bench.*line)->Inject(soon);
    std::string error = ErrorOf([&] {
      for (int i = 0; i < 100; ++i) {
        bench.DriveFor({0.2, 0.0}, 0.05);
        bench.robot->TakeSweep();
      }
    });
    bench.motors->CatchUp(bench.motors->Now() + 0.3);  // for the board's own timeout
    EXPECT_EQ(bench.device.motors().speeds(), (std::array<double, 2>{0.0, 0.0})) << error;
    return error;
  };
  const LineFault dead = Fault(LineFault::Kind::kDead, 0.0, 1000.0);
  EXPECT_THAT(error_while_driving(&RobotBench::motors, dead), HasSubstr("motor board"));
  EXPECT_THAT(error_while_driving(&RobotBench::scanner, dead), HasSubstr("has sent no sweep for 2 s"));
  EXPECT_THAT(error_while_driving(&RobotBench::motors, Fault(LineFault::Kind::kPowerLoss, 0.0, 0.05)),
              HasSubstr("without power"));
}

/// A person thinks, or a plan takes long: nobody reads meanwhile, and what was sent then is old.
TEST(HardwareRobot, SeesWhatIsThereNowAfterALongThought) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  for (const double seconds : {0.4, 3.0, 30.0}) {
    bench.robot->TakeScan();
    bench.motors->Read(bench.motors->Now() + seconds);  // while no other line is read
    bench.robot->Drive({0.1, 0.0});
    for (int i = 0; i < 3; ++i) {
      const double now = bench.robot->Now();
      const slam::LaserSweep sweep = bench.robot->TakeSweep();
      EXPECT_GT(sweep.stamp, now - 0.1) << seconds;
      EXPECT_LT(sweep.stamp, bench.robot->Now());
      bench.motors->Read(bench.motors->Now() + seconds);  // and while it streams
    }
    bench.Halt();
  }
}

/// A board that was silent for a moment: the wheels stand, and turn again with the next command.
TEST(HardwareRobot, GoesOnAfterLateAnswersOfItsMotors) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  const double start = bench.device.base().T_map_base_true().translation.x();
  for (int i = 0; i < 8; ++i) {
    bench.DriveFor({0.2, 0.0}, 0.3);
    bench.motors->Inject(Fault(LineFault::Kind::kDelay, bench.motors->Now(), 0.05 * (i + 1)));
  }
  bench.DriveFor({0.2, 0.0}, 1.5);
  EXPECT_GE(bench.robot->interruptions(), 2);
  EXPECT_FALSE(bench.robot->State().blocked);
  EXPECT_NEAR(bench.robot->State().velocity.forward, 0.2, 0.01);
  EXPECT_GT(bench.device.base().T_map_base_true().translation.x() - start, 0.3);
}

/// A scanner that boots in the middle of a scan: found again, and the scan taken again.
TEST(HardwareRobot, GoesOnWhereItCan) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  bench.scanner->Inject(Fault(LineFault::Kind::kPowerLoss, bench.scanner->Now() + 1.5, 0.1));
  const slam::Scan scan = bench.robot->TakeScan();
  EXPECT_GE(bench.robot->repeated_scans(), 1);
  const auto errors = ErrorsOf(scan, bench.robot->T_base_laser(), FurnishedRoom());
  EXPECT_LT(errors.back(), 0.012);
  bench.DriveFor({0.2, 0.0}, 0.5);
  bench.scanner->Inject(Fault(LineFault::Kind::kPowerLoss, bench.scanner->Now() + 0.1, 0.1));
  bench.DriveFor({0.2, 0.0}, 0.3);
  bench.robot->TakeSweep();  // waits for the scanner, and stands
  EXPECT_EQ(bench.device.motors().speeds()[0], 0.0);
}

/// A hobby servo measures nothing: its pitch is that of its pulse, a lag ago.
TEST(HardwareRobot, ScansWithAHobbyServo) {
  RobotBenchOptions options = Exact();
  options.hardware.servo_kind = options.emulated.servo_kind = ServoKind::kHobby;
  options.hardware.tilt.from = -0.9;
  options.hardware.tilt.to = 0.9;
  RobotBench bench(FurnishedRoom(), options);
  bench.robot->Connect();
  for (int i = 0; i < 2; ++i) {
    const slam::Scan scan = bench.robot->TakeScan();
    EXPECT_NEAR(static_cast<double>(scan.sweeps.size()), 128.0, 8.0);
    EXPECT_LT(scan.sweeps.front().pitch, -0.87);
    EXPECT_GT(scan.sweeps.back().pitch, 0.87);
    const auto errors = ErrorsOf(scan, bench.robot->T_base_laser(), FurnishedRoom());
    EXPECT_LT(errors[errors.size() / 2], 0.01);
    EXPECT_LT(errors.back(), 0.03);
  }
  options.hardware.hobby_servo.lag = 0.0;  // what is wrong of the lag turns the scan
  RobotBench wrong(FurnishedRoom(), options);
  wrong.robot->Connect();
  EXPECT_GT(ErrorsOf(wrong.robot->TakeScan(), wrong.robot->T_base_laser(), FurnishedRoom()).back(), 0.03);
}

TEST(HardwareRobot, SaysWhatHoldsTheMount) {
  RobotBenchOptions options = Exact();
  options.hardware.tilt.max_time = 2.0;
  RobotBench bench(FurnishedRoom(), options);
  bench.robot->Connect();
  bench.device.servo().SetStuck(true);
  EXPECT_THAT(ErrorOf([&] { bench.robot->TakeScan(); }), HasSubstr("servo 1"));
}

TEST(HardwareRobot, CannotTiltFartherThanItsMount) {
  RobotBenchOptions options = Exact();
  options.hardware.tilt.from = -1.35;
  EXPECT_THAT(ErrorOf([&] { RobotBench(FurnishedRoom(), options); }), HasSubstr("hardware.tilt.from"));
  options.hardware.tilt.from = 1.2;
  EXPECT_THAT(ErrorOf([&] { RobotBench(FurnishedRoom(), options); }), HasSubstr("hardware.tilt.from"));
}

/// The same seed gives the same bytes; another one does not.
TEST(HardwareRobot, RepeatsItself) {
  const auto ranges_of = [](std::uint64_t seed) {
    RobotBenchOptions options = Exact();
    options.seed = seed;
    options.base = {};
    options.ais = {};
    RobotBench bench(FurnishedRoom(), options);
    bench.robot->Connect();
    bench.DriveFor({0.3, 0.2}, 1.0);
    std::vector<float> ranges;
    for (const slam::LaserSweep& sweep : bench.robot->TakeScan().sweeps) {
      for (const float range : sweep.ranges) ranges.push_back(std::isnan(range) ? -1.0F : range);
    }
    return ranges;
  };
  EXPECT_EQ(ranges_of(1), ranges_of(1));
  EXPECT_NE(ranges_of(1), ranges_of(2));
}

}  // namespace
}  // namespace ariadne::drivers
