// The field side of the program as a user types it, on pseudo-terminals with emulated devices behind them.
#include <gmock/gmock.h>

#include <thread>

#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/emulated/pty_server.h"
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

}  // namespace
}  // namespace ariadne
