#include "drivers/hardware/devices/identify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "drivers/emulated/emulated_hobby_servo.h"
#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/emulated_lms200.h"
#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/emulated/pty_server.h"
#include "drivers/hardware/memory_line.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

slam::LaserSweep Flat(double, const slam::ScannerModel&, std::size_t beams) {
  slam::LaserSweep sweep;
  sweep.ranges.assign(beams, 2.0F);
  return sweep;
}

void ExpectFound(EmulatedDevice& device, DeviceKind kind, int baud, const char* description) {
  EmulatedLine line(device);
  const std::optional<FoundDevice> found = IdentifyDevice(line);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, kind);
  EXPECT_EQ(found->baud, baud);
  EXPECT_EQ(found->description, description);
}

TEST(IdentifyDevice, KnowsEachDeviceByItsAnswer) {
  EmulatedLms200Options booted;
  booted.boot_time = 0.0;
  EmulatedLms200 scanner(booted, Flat);
  ExpectFound(scanner, DeviceKind::kLms200, 9600, "LMS200;30106x;V02.10");
  EmulatedServoOptions servo_options;
  servo_options.id = 4;
  servo_options.baud = 1000000;
  EmulatedServo servo(servo_options);
  ExpectFound(servo, DeviceKind::kDynamixel, 1000000, "id 4 (model 1060)");
  EmulatedMotorsOptions motor_options;
  motor_options.address = 0x83;
  motor_options.baud = 115200;
  EmulatedMotors motors(motor_options);
  ExpectFound(motors, DeviceKind::kRoboclaw, 115200, "USB Roboclaw 2x15a v4.1.34, address 131");
  EmulatedHobbyServo controller;
  ExpectFound(controller, DeviceKind::kMaestro, 9600, "pulses of channel 0: 0 us, 1: 0 us");
}

TEST(IdentifyDevice, ChangesNothing) {
  EmulatedMotors motors;
  EmulatedServo servo;
  const double position = servo.position();
  EmulatedLine motor_line(motors);
  EmulatedLine servo_line(servo);
  EmulatedHobbyServo controller;
  EmulatedLine controller_line(controller);
  EXPECT_TRUE(IdentifyDevice(controller_line));
  EXPECT_EQ(controller.pulse(), 0.0) << "no question of another device is a pulse";
  EXPECT_TRUE(IdentifyDevice(motor_line));
  EXPECT_TRUE(IdentifyDevice(servo_line));
  EXPECT_EQ(motors.positions(), (std::array<double, 2>{0.0, 0.0}));
  EXPECT_EQ(servo.position(), position);
}

TEST(IdentifyDevice, FindsNothingWhereNothingAnswers) {
  MemoryLine line;
  EXPECT_FALSE(IdentifyDevice(line.end(0)));
  EXPECT_LT(line.end(0).Now(), 5.0);
}

TEST(ListDevices, SaysWhatIsOnEachPort) {
  EmulatedMotors motors;
  PtyServer server(motors);
  const std::jthread thread([&](const std::stop_token& stop) { server.Serve(stop); });
  const std::vector<DeviceListing> listings =
      ListDevices({{server.path(), server.path()}, {"/dev/no_such_port", "/dev/no_such_port"}});
  ASSERT_EQ(listings.size(), 2U);
  ASSERT_TRUE(listings[0].device);
  EXPECT_EQ(listings[0].device->kind, DeviceKind::kRoboclaw);
  EXPECT_THAT(listings[1].problem, testing::HasSubstr("/dev/no_such_port"));
}

}  // namespace
}  // namespace ariadne::drivers
