// The list before a robot leaves, on emulated devices in a room.
#include "experiments/field/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/drivers/emulated/robot/robot_bench.h"
#include "tests/slam/io/support.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;

/// An emulated robot that is not driven by anybody else.
class PreflightTest : public testing::Test {
 protected:
  PreflightTest() {
    bench_.hardware.mount.pitch = 0.001;
    system_ = {50e9, 1.8e9, 1.7e9};
  }

  std::vector<PreflightItem> Check() {
    scene_ = std::make_shared<drivers::RayScene>(drivers::FurnishedRoom());
    device_ = std::make_unique<drivers::EmulatedRobot>(scene_, bench_.base, bench_.ais, bench_.emulated, 1);
    if (prepare_) prepare_(*device_);
    drivers::EmulatedLines lines = drivers::LinesTo(*device_);
    const auto once = [](std::unique_ptr<drivers::EmulatedLine>& line) {
      return [&line]() -> std::unique_ptr<drivers::ByteStream> {
        if (line == nullptr) Fail("cannot open /dev/none: is the adapter plugged in?");
        return std::move(line);
      };
    };
    if (unplugged_) lines.servo.reset();
    std::vector<PreflightItem> items = CheckRobot(
        bench_.hardware, options_, {once(lines.scanner), once(lines.servo), once(lines.motors)}, system_);
    EXPECT_EQ(device_->base().path_true().size(), 1U) << "the robot stayed where it was";
    return items;
  }
  /// The text of the only red item; the test fails where there are others.
  std::string OnlyRed(const std::string& name) {
    const std::vector<PreflightItem> items = Check();
    std::string text;
    for (const PreflightItem& item : items) {
      if (item.name == name) text = item.text;
      EXPECT_EQ(item.ok, item.name != name) << item.name << ": " << item.text;
    }
    return text;
  }

  drivers::RobotBenchOptions bench_ = drivers::Exact();
  PreflightOptions options_;
  PreflightSystem system_;
  std::function<void(drivers::EmulatedRobot&)> prepare_;
  bool unplugged_ = false;
  std::shared_ptr<drivers::RayScene> scene_;
  std::unique_ptr<drivers::EmulatedRobot> device_;
};

TEST_F(PreflightTest, IsGreenForARobotInOrder) {
  const std::vector<PreflightItem> items = Check();
  for (const PreflightItem& item : items) EXPECT_TRUE(item.ok) << item.name << ": " << item.text;
  const std::string text = ToText(items);
  for (const char* name : {"disk space", "clock", "calibration", "scanner", "servo", "motor board",
                           "battery", "emergency stop", "warnings", "test sweep", "wheels", "test scan"})
    EXPECT_THAT(text, HasSubstr(std::string("green  ") + name));
  EXPECT_THAT(text, HasSubstr("LMS200;30106x"));
}

TEST_F(PreflightTest, IsGreenWithAHobbyServo) {
  bench_.hardware.servo_kind = bench_.emulated.servo_kind = drivers::ServoKind::kHobby;
  bench_.hardware.tilt.from = -0.9;
  bench_.hardware.tilt.to = 0.9;
  for (const PreflightItem& item : Check()) {
    EXPECT_TRUE(item.ok) << item.name << ": " << item.text;
    if (item.name == "servo") EXPECT_THAT(item.text, HasSubstr("channel 0"));
  }
  bench_.hardware.tilt.to = 1.15;
  EXPECT_THAT(ErrorOf([this] { Check(); }), HasSubstr("hardware.hobby_servo.min_angle"));
}

TEST_F(PreflightTest, IsRedForWhatIsWrongWithTheComputer) {
  options_.scan = false;
  system_.free_bytes = 1e9;
  EXPECT_THAT(OnlyRed("disk space"), HasSubstr("1.0 GB"));
  system_.free_bytes = 50e9;
  system_.wall_time = 1e6;
  EXPECT_THAT(OnlyRed("clock"), HasSubstr("before 2024"));
  system_.wall_time = 1.71e9;
  system_.config_time = 1.72e9;
  EXPECT_THAT(OnlyRed("clock"), HasSubstr("configuration"));
}

TEST_F(PreflightTest, IsRedForWhatIsWrongWithTheRobot) {
  options_.scan = false;
  bench_.hardware.mount.pitch = 0.0;
  EXPECT_THAT(OnlyRed("calibration"), HasSubstr("ariadne calibrate scanner"));
  options_.uncalibrated = true;
  bench_.emulated.motors.battery = 20.5;
  EXPECT_THAT(OnlyRed("battery"), HasSubstr("20.5 V"));
  bench_.emulated.motors.battery = 24.0;
  prepare_ = [](drivers::EmulatedRobot& robot) { robot.motors().SetStatus(0x0800); };
  EXPECT_THAT(OnlyRed("warnings"), HasSubstr("main battery rather low"));
}

TEST_F(PreflightTest, IsRedWhileTheEmergencyStopIsPressed) {
  options_.scan = false;
  prepare_ = [](drivers::EmulatedRobot& robot) { robot.motors().SetStatus(0x0004); };
  const std::vector<PreflightItem> items = Check();
  const auto stop = std::ranges::find(items, "emergency stop", &PreflightItem::name);
  ASSERT_NE(stop, items.end());
  EXPECT_FALSE(stop->ok);
  EXPECT_THAT(stop->text, HasSubstr("release it"));
  prepare_ = {};
  options_.press_stop = 1.0;
  EXPECT_THAT(OnlyRed("emergency stop"), HasSubstr("has not seen"));
}

/// A device that does not answer is a red line, and the others are asked all the same.
TEST_F(PreflightTest, AsksTheOthersWhereOneIsSilent) {
  unplugged_ = true;
  EXPECT_THAT(OnlyRed("servo"), HasSubstr("plugged in"));
  unplugged_ = false;
  bench_.hardware.motors.address = 0x81;
  EXPECT_THAT(OnlyRed("motor board"), HasSubstr("address 129"));
}

/// A mount that has been knocked, by 2 deg, shows in the floor of the scan.
TEST_F(PreflightTest, SeesAMountThatIsNotAsItWas) {
  bench_.hardware.mount.pitch = 0.035;
  EXPECT_THAT(OnlyRed("test scan"), HasSubstr("slopes"));
  bench_.hardware.mount.pitch = 0.001;
  bench_.hardware.mount.z = 1.05;
  EXPECT_THAT(OnlyRed("test scan"), HasSubstr("0.1"));
}

TEST(AskSystem, LooksAtThisComputer) {
  const slam::testing_support::TemporaryFolder folder;
  folder.Write("my.yaml", "experiment: explore\n");
  const PreflightSystem system =
      AskSystem((folder / "results/to/come").string(), (folder / "my.yaml").string());
  EXPECT_GT(system.free_bytes, 0.0);
  EXPECT_NEAR(system.wall_time, system.config_time, 3600.0);
}

}  // namespace
}  // namespace ariadne::experiments
