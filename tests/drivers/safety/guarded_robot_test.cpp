#include "drivers/safety/guarded_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drivers/emergency_stopped.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Wheels that do what they are told, a scanner that lives until a time, and a note of each command.
class FakeRobot : public Robot {
 public:
  struct Command {
    double time = 0.0;
    double forward = 0.0;
  };
  double Now() const override { return now; }
  slam::Pose3 T_base_laser() const override { return {}; }
  slam::Scan TakeScan() override {
    Drive({});
    now += 5.0;
    ++scans;
    return {};
  }
  slam::LaserSweep TakeSweep() override {
    if (now > scanner_throws_from) Fail("the scanner does not answer");
    return {std::min(now, scanner_lives_until), 0.0, 0.0, {1.0F}, {}};
  }
  std::vector<SafetySweep> TakeSafetySweeps() override {
    if (!has_safety_scanners) return {};
    return {{{}, {}, TakeSweep()}};
  }
  RobotState State() override {
    RobotState state;
    state.stamp = now;
    state.velocity.forward = commands.empty() ? 0.0 : commands.back().forward;
    return state;
  }
  void Drive(const Velocity& velocity) override {
    if (now > motors_throw_from) Fail("the motor board does not answer");
    commands.push_back({now, velocity.forward});
  }
  void WaitUntil(double time) override { now = std::max(now, time); }

  /// When the wheels were told to stand last; infinity if they turn.
  double StoodFrom() const {
    double from = kNever;
    for (const Command& command : commands) {
      if (command.forward != 0.0) from = kNever;
      if (command.forward == 0.0 && from == kNever) from = command.time;
    }
    return from;
  }

  double now = 100.0;
  double scanner_lives_until = kNever;
  double scanner_throws_from = kNever;
  double motors_throw_from = kNever;
  bool has_safety_scanners = true;
  int scans = 0;
  std::vector<Command> commands;
};

class GuardedRobotTest : public testing::Test {
 protected:
  FakeRobot robot_;
  double pressed_at_ = kNever;
  EmergencyStop stop_{
      [this] { return robot_.now >= pressed_at_ ? std::string("a key was pressed") : std::string(); }};
  GuardedRobot guarded_{robot_, stop_};
};

TEST_F(GuardedRobotTest, DrivesAsLongAsNothingIsWrong) {
  for (int i = 0; i < 100; ++i) {
    guarded_.Drive({0.5, 0.1});
    guarded_.WaitUntil(guarded_.Now() + 0.1);
  }
  EXPECT_EQ(robot_.commands.size(), 100U);
  EXPECT_EQ(robot_.StoodFrom(), kNever);
  EXPECT_EQ(guarded_.stopped_because(), "");
  EXPECT_FALSE(guarded_.State().blocked);
  EXPECT_NEAR(guarded_.Now(), 110.0, 1e-9);
}

TEST_F(GuardedRobotTest, StopsWithin100MsOfTheEmergencyStopAndStaysSo) {
  pressed_at_ = 100.33;
  guarded_.Drive({0.5, 0.0});
  guarded_.WaitUntil(100.45);
  EXPECT_GE(robot_.StoodFrom(), 100.33);
  EXPECT_LE(robot_.StoodFrom(), 100.43);
  EXPECT_EQ(guarded_.Now(), 100.45);
  pressed_at_ = kNever;  // the key is up again, but it latches
  EXPECT_THAT(ErrorOf([&] { guarded_.Drive({0.1, 0.0}); }), HasSubstr("a key was pressed"));
  EXPECT_THAT(ErrorOf([&] { guarded_.Drive({0.0, 0.1}); }), HasSubstr("a key was pressed"));
  EXPECT_THAT(ErrorOf([&] { guarded_.TakeScan(); }), HasSubstr("a key was pressed"));
  EXPECT_THROW(guarded_.TakeScan(), EmergencyStopped);  // other than what is broken
  EXPECT_THROW(guarded_.Drive({0.1, 0.0}), EmergencyStopped);
  EXPECT_EQ(robot_.scans, 0);
  EXPECT_NO_THROW(guarded_.Drive({}));
  EXPECT_TRUE(guarded_.State().blocked);
  EXPECT_EQ(robot_.commands.back().forward, 0.0);
  stop_.Release();
  guarded_.Drive({0.1, 0.0});
  EXPECT_EQ(robot_.commands.back().forward, 0.1);
  EXPECT_FALSE(guarded_.State().blocked);
}

TEST_F(GuardedRobotTest, DoesNotReleaseWhatIsStillWrong) {
  pressed_at_ = 0.0;
  EXPECT_THROW(guarded_.Drive({0.5, 0.0}), Error);
  stop_.Release();
  EXPECT_THROW(guarded_.Drive({0.5, 0.0}), Error);
  EXPECT_TRUE(robot_.commands.empty());
}

/// The guard looks by itself half way to the timeout, so that a commander who does not look is no reason.
TEST_F(GuardedRobotTest, StopsWhenNoSweepComesAnyMore) {
  robot_.scanner_lives_until = 101.02;
  std::string error;
  while (error.empty() && guarded_.Now() < 105.0) {
    try {
      guarded_.Drive({0.5, 0.0});
      guarded_.WaitUntil(guarded_.Now() + 0.1);
    } catch (const Error& caught) {
      error = caught.what();
    }
  }
  EXPECT_THAT(error, HasSubstr("no sweep came for 0.5 s"));
  EXPECT_GE(robot_.StoodFrom(), 101.5);
  EXPECT_LE(robot_.StoodFrom(), 101.02 + 0.5 + 0.1);
  EXPECT_THROW(guarded_.Drive({0.5, 0.0}), Error);
  robot_.scanner_lives_until = kNever;
  EXPECT_NO_THROW(guarded_.Drive({0.5, 0.0}));
}

TEST_F(GuardedRobotTest, LooksWithTheScannerWhereThereAreNoSafetyScanners) {
  robot_.has_safety_scanners = false;
  robot_.scanner_lives_until = 102.0;
  for (int i = 0; i < 20; ++i) {
    guarded_.Drive({0.5, 0.0});
    guarded_.WaitUntil(guarded_.Now() + 0.1);
  }
  EXPECT_EQ(robot_.StoodFrom(), kNever);
  guarded_.WaitUntil(103.0);
  EXPECT_LE(robot_.StoodFrom(), 102.6);
}

TEST_F(GuardedRobotTest, DoesNotStartBlind) {
  robot_.scanner_lives_until = 50.0;
  EXPECT_THAT(ErrorOf([&] { guarded_.Drive({0.5, 0.0}); }), HasSubstr("no sweep"));
  EXPECT_TRUE(robot_.commands.empty());
  GuardOptions options;
  options.sensor_timeout = 0.0;  // a robot without scanners
  GuardedRobot blind(robot_, stop_, options);
  EXPECT_NO_THROW(blind.Drive({0.5, 0.0}));
}

TEST_F(GuardedRobotTest, StopsWhenNoCommandComes) {
  guarded_.Drive({0.5, 0.0});
  guarded_.WaitUntil(103.0);
  EXPECT_GT(robot_.StoodFrom(), 100.5);
  EXPECT_LE(robot_.StoodFrom(), 100.6);
  EXPECT_THAT(guarded_.stopped_because(), HasSubstr("no command"));
  guarded_.Drive({0.5, 0.0});  // which is no fault of the robot
  EXPECT_EQ(robot_.commands.back().forward, 0.5);
}

/// A program that computed for long finds the wheels stopped by its next call, whatever that is.
TEST_F(GuardedRobotTest, LooksAtEachCall) {
  guarded_.Drive({0.5, 0.0});
  robot_.now += 2.0;
  guarded_.TakeSweep();
  EXPECT_EQ(robot_.StoodFrom(), 102.0);
}

TEST_F(GuardedRobotTest, LeavesTheWheelsStandingWhereACallFails) {
  robot_.scanner_throws_from = 100.05;
  guarded_.Drive({0.5, 0.0});
  guarded_.WaitUntil(100.1);
  EXPECT_THAT(ErrorOf([&] { guarded_.TakeSafetySweeps(); }), HasSubstr("the scanner does not answer"));
  EXPECT_EQ(robot_.StoodFrom(), 100.1);
  EXPECT_NO_THROW(guarded_.Drive({}));
}

TEST_F(GuardedRobotTest, PressesTheStopWhereTheWheelsCannotBeStopped) {
  guarded_.Drive({0.5, 0.0});
  robot_.motors_throw_from = 100.0;
  robot_.now = 100.01;
  EXPECT_THAT(ErrorOf([&] { guarded_.Drive({0.4, 0.0}); }), HasSubstr("the motor board"));
  robot_.motors_throw_from = kNever;
  EXPECT_THAT(ErrorOf([&] { guarded_.Drive({0.4, 0.0}); }), HasSubstr("may be turning"));
}

TEST_F(GuardedRobotTest, PassesOnWhatItGuards) {
  guarded_.TakeScan();
  EXPECT_EQ(robot_.scans, 1);
  EXPECT_EQ(guarded_.TakeSafetySweeps().size(), 1U);
  guarded_.WaitUntil(200.0);
  EXPECT_EQ(guarded_.Now(), 200.0);
  GuardOptions wrong;
  wrong.check_period = 1.0;
  EXPECT_THROW(GuardedRobot(robot_, stop_, wrong), Error);
}

}  // namespace
}  // namespace ariadne::drivers
