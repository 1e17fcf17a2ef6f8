#include "drivers/replay/recording_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/replay/call_bytes.h"
#include "tests/drivers/replay/full_disk.h"
#include "tests/drivers/replay/scripted_robot.h"
#include "tests/slam/io/support.h"

namespace ariadne::drivers {
namespace {

using slam::testing_support::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(RecordingRobot, HasEachAnswerOnTheLogBeforeTheMission) {
  const TemporaryFolder folder;
  RobotLogWriter writer(folder / "robot.log");
  ScriptedRobot robot;
  RecordingRobot recording(robot, writer);
  const auto last = [&] {
    RobotLog log = ReadRobotLog(folder / "robot.log");
    return log.Read(log.size() - 1);
  };
  robot.state.stamp = 2.5;
  EXPECT_EQ(recording.Now(), 2.5);
  EXPECT_EQ(std::get<NowCall>(last()).time, 2.5);
  EXPECT_EQ(recording.TakeScan().sweeps.size(), 2U);
  EXPECT_EQ(std::get<ScanCall>(last()).scan.sweeps[1].stamp, 2.5);
  recording.Drive({0.5, 0.0});
  EXPECT_EQ(std::get<DriveCall>(last()).velocity.forward, 0.5);
  EXPECT_THAT(robot.told, ElementsAre(0.5));
  recording.WaitUntil(3.0);
  EXPECT_EQ(std::get<WaitCall>(last()).until, 3.0);
  recording.Note("because");
  EXPECT_EQ(std::get<Note>(last()).text, "because");
  const auto expect_last = [&](const RobotCall& call) { EXPECT_EQ(EncodeCall(last()), EncodeCall(call)); };
  expect_last(StateCall{recording.State()});
  expect_last(SweepCall{recording.TakeSweep()});
  expect_last(SafetySweepsCall{recording.TakeSafetySweeps()});
  expect_last(MountingCall{recording.T_base_laser()});
}

TEST(RecordingRobot, PassesErrorsAndForgetsThem) {
  const TemporaryFolder folder;
  RobotLogWriter writer(folder / "robot.log");
  ScriptedRobot robot;
  robot.broken = true;
  RecordingRobot recording(robot, writer);
  EXPECT_EQ(ErrorOf([&] { recording.TakeScan(); }), "the scanner does not answer");
  EXPECT_EQ(ReadRobotLog(folder / "robot.log").size(), 0U);
}

TEST(RecordingRobot, StopsTheWheelsWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  RobotLogWriter writer(folder / "robot.log");
  ScriptedRobot robot;
  RecordingRobot recording(robot, writer);
  recording.Drive({0.5, 0.0});
  const FullDisk disk(std::filesystem::file_size(folder / "robot.log") + 3);
  EXPECT_THAT(ErrorOf([&] { recording.State(); }),
              HasSubstr("robot.log: cannot be written: File too large"));
  EXPECT_THAT(robot.told, ElementsAre(0.5, 0.0));
}

}  // namespace
}  // namespace ariadne::drivers
