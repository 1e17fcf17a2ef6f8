// The field side of the program as a user types it, on pseudo-terminals with emulated devices behind them.
#include <gmock/gmock.h>

#include <thread>

#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/emulated/pty_server.h"
#include "tests/experiments/field/recorded_devices.h"
#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using Devices = ProgramTest;

TEST_F(Devices, AreNamedByTheirAnswers) {
  drivers::EmulatedMotors motors;
  drivers::EmulatedServo servo;
  drivers::PtyServer motor_port(motors);
  drivers::PtyServer servo_port(servo);
  const std::jthread motor_thread([&](const std::stop_token& stop) { motor_port.Serve(stop); });
  const std::jthread servo_thread([&](const std::stop_token& stop) { servo_port.Serve(stop); });
  const std::string out = Must("devices -q " + motor_port.path() + " " + servo_port.path());
  EXPECT_THAT(out, testing::ContainsRegex(motor_port.path() + " +RoboClaw +38400 +USB Roboclaw"));
  EXPECT_THAT(out, testing::ContainsRegex(servo_port.path() + " +Dynamixel +57600 +id 1"));
  EXPECT_EQ(motors.positions()[0], 0.0);
}

TEST_F(Devices, ThatAreNotThereAreASentenceAndStatusOne) {
  const Ended ended = Ariadne("devices -q /dev/no_such_port");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("cannot open /dev/no_such_port"), HasSubstr("plugged in")));
  folder_.Write("file", "no port");
  EXPECT_THAT(Ariadne("devices -q file").out, HasSubstr("file"));
}

TEST_F(Devices, OfThisComputerAreListedWithoutArguments) {
  EXPECT_THAT(Must("devices -q"), testing::AnyOf(HasSubstr("no serial ports"), HasSubstr("it says")));
}

TEST_F(Devices, OfARobotThatIsNotThereAreRed) {
  folder_.Write("robot.yaml",
                "experiment: explore\nrobot: hardware\nhardware:\n  servo:\n    port: /dev/none\n");
  const Ended ended = Ariadne("check robot.yaml -q");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("RED    scanner"), HasSubstr("hardware.scanner.port is not given"),
                               HasSubstr("cannot open /dev/none"), HasSubstr("green  clock"),
                               HasSubstr("are red: do not drive")));
  EXPECT_THAT(Ariadne("check none.yaml").err, HasSubstr("none.yaml"));
}

TEST_F(Devices, AreCalibratedFromFiles) {
  folder_.Write("squares.txt", "ccw 0.01 0.02\ncw 0.01 -0.02\n");
  EXPECT_THAT(Ariadne("calibrate wheels squares.txt").err, HasSubstr("too few; drive at least 3"));
  EXPECT_EQ(Ariadne("calibrate scanner none").status, 1);
  EXPECT_EQ(Ariadne("calibrate").status, 2);
}

using LineLogs = ProgramTest;

TEST_F(LineLogs, AreShownAndTakenApart) {
  {
    experiments::RecordedDevices devices(folder_ / "lines");
    devices.motors.Connect();
    devices.motors.Encoders();
  }
  EXPECT_THAT(Must("log info lines"), AllOf(HasSubstr("whole to its end"), HasSubstr("RoboClaw")));
  EXPECT_EQ(Must("log info ."), Must("log info ./lines.000"));
  Must("log export lines --to telegrams");
  EXPECT_THAT(Content("lines.telegrams.txt"), HasSubstr(" 2 > ask for the version\n"));
  EXPECT_EQ(Must("log export lines --to odometry --out counts.csv"), "counts.csv: 1 readings\n");
  EXPECT_EQ(Ariadne("log export lines --to xyz").err, "ariadne: lines: holds no sweeps of a scanner\n");
  EXPECT_EQ(Ariadne("log info none").err,
            "ariadne: none: there is no such log or folder; check the path\n");
  EXPECT_EQ(Ariadne("log export lines --to las").status, 2);
  EXPECT_EQ(Ariadne("log").status, 2);
}

}  // namespace
}  // namespace ariadne
