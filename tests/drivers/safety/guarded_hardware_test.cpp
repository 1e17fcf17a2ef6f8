// The guard on the drivers of a real robot, whose devices are emulated in one world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/safety/guarded_robot.h"
#include "tests/drivers/emulated/robot/robot_bench.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

constexpr double kNotPressed = 1e9;

class GuardedHardware : public testing::Test {
 protected:
  GuardedHardware() { bench_.robot->Connect(); }

  /// As a mission does: looks, commands, waits; until it throws or the time is over. What it threw.
  std::string DriveUntil(double time) {
    try {
      while (guarded_.Now() < time) {
        guarded_.TakeSweep();
        guarded_.Drive({0.4, 0.0});
        guarded_.WaitUntil(guarded_.Now() + 0.1);
      }
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  double SpeedAfter(double seconds) {
    DiscardUntil(*bench_.motors, bench_.motors->Now() + seconds);
    return bench_.device.motors().speeds()[0];
  }

  RobotBench bench_{EmptyRoom({-6.0, -3.0, 0.0}, {9.0, 3.0, 2.7})};
  double pressed_at_ = kNotPressed;
  EmergencyStop stop_{[this] {
    return bench_.robot->Now() >= pressed_at_ ? std::string("a key was pressed") : std::string();
  }};
  GuardedRobot guarded_{*bench_.robot, stop_};
};

TEST_F(GuardedHardware, DrivesAsTheRobotDoes) {
  EXPECT_EQ(DriveUntil(guarded_.Now() + 3.0), "");
  EXPECT_NEAR(guarded_.State().velocity.forward, 0.4, 0.02);
  EXPECT_EQ(guarded_.stopped_because(), "");
}

TEST_F(GuardedHardware, StopsByTheEmergencyStop) {
  pressed_at_ = guarded_.Now() + 2.0;
  EXPECT_THAT(DriveUntil(pressed_at_ + 1.0), HasSubstr("a key was pressed"));
  EXPECT_LT(guarded_.Now(), pressed_at_ + 0.25);
  EXPECT_EQ(SpeedAfter(0.7), 0.0);  // by its acceleration
}

/// The scanner's plug is pulled: the wheels stand long before the driver gives the scanner up.
TEST_F(GuardedHardware, StopsWhenTheScannerIsGone) {
  const double gone = guarded_.Now() + 2.0;
  EXPECT_EQ(DriveUntil(gone), "");
  bench_.scanner->Inject({.kind = LineFault::Kind::kDead, .time = bench_.scanner->Now(), .duration = 1e6});
  EXPECT_NE(DriveUntil(gone + 5.0), "");
  EXPECT_EQ(SpeedAfter(0.7), 0.0);
}

}  // namespace
}  // namespace ariadne::drivers
