#include "drivers/replay/compared_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/replay/recording_robot.h"
#include "tests/drivers/replay/scripted_robot.h"
#include "tests/slam/io/support.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a mission does; `speed` is its decision.
void DriveABit(LoggedRobot& robot, double speed = 0.5, const std::string& note = "ahead") {
  robot.TakeScan();
  robot.Note(note);
  robot.Drive({speed, 0.0});
  robot.WaitUntil(3.0);
  robot.State();
  robot.Now();
}

class Compared : public testing::Test {
 protected:
  Compared() : log_(Recorded()) {}
  RobotLog Recorded() const {
    RobotLogWriter writer(folder_ / "robot.log");
    ScriptedRobot robot;
    RecordingRobot recording(robot, writer);
    DriveABit(recording);
    return ReadRobotLog(folder_ / "robot.log");
  }

  slam::testing_support::TemporaryFolder folder_;
  RobotLog log_;
  ScriptedRobot robot_;
};

TEST_F(Compared, IsTheRobotWhereAllIsTheSame) {
  ComparedRobot compared(robot_, log_);
  DriveABit(compared);
  EXPECT_THAT(robot_.told, ElementsAre(0.5));
  EXPECT_EQ(compared.compared(), 6U);
  EXPECT_EQ(compared.left(), 0U);
  compared.Drive({0.25, 0.0});  // the log has ended
  compared.Note("further");
  EXPECT_THAT(robot_.told, ElementsAre(0.5, 0.25));
}

/// Before it is done.
TEST_F(Compared, SaysWhichCallIsAnotherOne) {
  ComparedRobot compared(robot_, log_);
  EXPECT_THAT(ErrorOf([&] { DriveABit(compared, 0.25); }),
              AllOf(HasSubstr("call 3"), HasSubstr("recorded as Drive(0.5 m/s, 0 rad/s)"),
                    HasSubstr("now Drive(0.25 m/s, 0 rad/s)")));
  EXPECT_THAT(robot_.told, IsEmpty());
}

TEST_F(Compared, SaysWhichNoteIsAnotherOne) {
  ComparedRobot compared(robot_, log_);
  EXPECT_THAT(ErrorOf([&] { DriveABit(compared, 0.5, "back"); }),
              HasSubstr("call 2 (0.013 s) was recorded as the note \"ahead\"; now the note \"back\""));
  ComparedRobot silent(robot_, log_);
  silent.TakeScan();
  EXPECT_THROW(silent.Drive({0.5, 0.0}), DepartedFromLog);
}

TEST_F(Compared, SaysWhichAnswerIsAnotherOne) {
  ComparedRobot compared(robot_, log_);
  robot_.state.stamp = 1e-9;
  EXPECT_THAT(ErrorOf([&] { DriveABit(compared); }),
              AllOf(HasSubstr("call 1"), HasSubstr("TakeScan()"), HasSubstr("another answer")));
}

/// As far as a start of a run went that a later one has gone on from.
TEST_F(Compared, EndsWithATruncatedLog) {
  log_.Truncate(2);
  log_.Truncate(9);
  EXPECT_EQ(log_.size(), 2U);
  ComparedRobot compared(robot_, log_);
  DriveABit(compared, 0.25);
  EXPECT_EQ(compared.compared(), 2U);
}

}  // namespace
}  // namespace ariadne::drivers
