#include "drivers/replay/replay_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/replay/fast_forward.h"
#include "drivers/replay/recording_robot.h"
#include "tests/drivers/replay/simulation.h"
#include "tests/slam/io/support.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;
using slam::testing_support::ContentOf;
using slam::testing_support::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

constexpr std::uint64_t kSeed = 3;

/// A run of the small mission that nothing disturbed, with its log.
class Replay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene = SceneWithWalker();
    folder = std::make_unique<TemporaryFolder>();
    path = folder->path() / "robot.log";
    SimulatedRobot robot(scene, CoarseRobot(), kSeed);
    RobotLogWriter log(path);
    RecordingRobot recording(robot, log);
    Witness witness(recording);
    RunSmallMission(witness, &recording);
    ASSERT_GT(robot.repeated_scans(), 0);
    seen = witness.seen();
    truth = robot.T_map_base_true();
    end = robot.Now();
  }
  static void TearDownTestSuite() { folder.reset(); }

  inline static std::shared_ptr<const RayScene> scene;
  inline static std::unique_ptr<TemporaryFolder> folder;
  inline static fs::path path;
  inline static std::vector<std::string> seen;
  inline static slam::Pose2 truth;
  inline static double end = 0.0;
};

TEST_F(Replay, RecordsWithoutAnEffect) {
  SimulatedRobot robot(scene, CoarseRobot(), kSeed);
  Witness witness(robot);
  RunSmallMission(witness);
  EXPECT_TRUE(witness.seen() == seen);
}

TEST_F(Replay, AnswersTheSame) {
  RobotLog log = ReadRobotLog(path);
  ReplayRobot replay(log);
  Witness witness(replay);
  EXPECT_TRUE(replay.Replayed());
  EXPECT_EQ(replay.CallsLeft(), log.size());
  RunSmallMission(witness, &replay);
  EXPECT_TRUE(witness.seen() == seen);
  EXPECT_FALSE(replay.Replayed());
  EXPECT_THROW(replay.Now(), LogEnded);
}

TEST_F(Replay, SaysWhereTheMissionDeparts) {
  RobotLog log = ReadRobotLog(path);
  ReplayRobot replay(log);
  EXPECT_THAT(ErrorOf([&] { RunSmallMission(replay, nullptr, 1.0 + 1e-15); }),
              AllOf(HasSubstr("robot.log: the mission departs from its log at call 8 (5.120 s)"),
                    HasSubstr("asks for Drive(0."), HasSubstr("log has Drive(0.")));
}

TEST_F(Replay, GoesOnAfterAKillAsIfNothingHadHappened) {
  RandomStream stream = NamedStream(1, "kills");
  const auto size = fs::file_size(path);
  for (int kill = 0; kill < 12; ++kill) {
    const fs::path killed = folder->path() / "killed.log";
    fs::copy_file(path, killed, fs::copy_options::overwrite_existing);
    fs::resize_file(killed, stream() % size);
    RobotLog log = ReadRobotLog(killed);
    SimulatedRobot robot(scene, CoarseRobot(), kSeed);
    FastForward(robot, log);
    RobotLogWriter more(killed);
    ReplayRobot replay(log, {[&]() -> Robot& { return robot; }, Seam::kNone, &more});
    Witness witness(replay);
    RunSmallMission(witness, &replay);
    EXPECT_TRUE(witness.seen() == seen);
    EXPECT_EQ(robot.T_map_base_true().translation, truth.translation);
    EXPECT_EQ(robot.T_map_base_true().angle, truth.angle);
    EXPECT_EQ(robot.Now(), end);
    EXPECT_TRUE(ContentOf(killed) == ContentOf(path)) << "the log that goes on";
  }
}

TEST_F(Replay, IsNoFunctionOfItsNotes) {
  RobotLog log = ReadRobotLog(path);
  ReplayRobot replay(log);
  Witness witness(replay);
  replay.Note("one more");
  RunSmallMission(witness);  // leaves no notes
  EXPECT_TRUE(witness.seen() == seen);
}

TEST_F(Replay, NoticesOnTheWayForwardThatItIsAnotherRobot) {
  RobotLog log = ReadRobotLog(path);
  SimulatedRobot other_seed(scene, CoarseRobot(), kSeed + 1);
  EXPECT_THAT(ErrorOf([&] { FastForward(other_seed, log); }),
              HasSubstr("robot.log: the simulated robot departs from the log at call 2 ("))
      << "by the noise of the scan";
  SimulatedRobotOptions options = CoarseRobot();
  options.base.wheels.acceleration *= 1.01;
  SimulatedRobot stronger(scene, options, kSeed);
  EXPECT_THAT(ErrorOf([&] { FastForward(stronger, log); }), HasSubstr("State(); go on with the world"));
  SimulatedRobot same(scene, CoarseRobot(), kSeed);
  FastForward(same, log);
  EXPECT_EQ(same.Now(), end);
}

TEST_F(Replay, EndsWhereNobodyGoesOn) {
  const fs::path killed = folder->path() / "short.log";
  fs::copy_file(path, killed, fs::copy_options::overwrite_existing);
  fs::resize_file(killed, fs::file_size(path) / 2);
  RobotLog log = ReadRobotLog(killed);
  ReplayRobot replay(log);
  EXPECT_THROW(RunSmallMission(replay), LogEnded);
  EXPECT_EQ(replay.CallsLeft(), 0U);
}

}  // namespace
}  // namespace ariadne::drivers
