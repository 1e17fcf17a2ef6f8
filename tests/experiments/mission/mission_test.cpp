#include "experiments/mission/mission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/emergency_stopped.h"
#include "drivers/replay/fast_forward.h"
#include "drivers/replay/recording_robot.h"
#include "drivers/replay/replay_robot.h"
#include "experiments/mission/fence.h"
#include "slam/geometry/angles.h"
#include "tests/experiments/mission/two_rooms.h"
#include "tests/slam/io/support.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;

void ExpectSameStops(const MissionResult& a, const MissionResult& b) {
  ASSERT_EQ(a.stops.size(), b.stops.size());
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.time, b.time);
  for (std::size_t i = 0; i < a.stops.size(); ++i) {
    EXPECT_EQ(a.stops[i].T_map_base.angle, b.stops[i].T_map_base.angle) << i;
    EXPECT_EQ(a.stops[i].T_map_base.translation, b.stops[i].T_map_base.translation) << i;
    EXPECT_EQ(a.stops[i].distance, b.stops[i].distance) << i;
    EXPECT_EQ(a.stops[i].unseen, b.stops[i].unseen) << i;
    EXPECT_EQ(a.scans[i].T_map_laser.translation, b.scans[i].T_map_laser.translation) << i;
  }
}

TEST(Mission, SeesTwoRoomsAndEndsByItself) {
  const MissionWorld world = PrepareTwoRooms();
  drivers::SimulatedRobot robot(world.scene, QuickRobot(), 1);
  const SimulatedMission mission = RunSimulatedMission(robot, robot, world.floor, {}, QuickMission(), 1);
  const MissionResult& result = mission.mission;
  EXPECT_EQ(result.end, MissionEnd::kNothingLeft) << Describe(result.end);
  ASSERT_GE(result.stops.size(), 3U);
  EXPECT_EQ(result.scans.size(), result.stops.size());
  EXPECT_EQ(mission.truth.size(), result.stops.size());
  EXPECT_LT(mission.truth.front().covered, 0.7);
  EXPECT_GT(mission.truth.back().covered, 0.97);
  EXPECT_TRUE(mission.collisions.empty());
  for (std::size_t i = 0; i < result.stops.size(); ++i) {
    const slam::Pose2 off =
        (mission.T_world_map * result.stops[i].T_map_base).Inverse() * mission.truth[i].T_world_base;
    EXPECT_LT(off.translation.norm(), 0.05) << i;
    EXPECT_LT(std::abs(off.angle), 0.02) << i;
  }
  EXPECT_LE(StopsTo(mission, 0.9), static_cast<double>(result.stops.size()));
  EXPECT_TRUE(std::isinf(WayTo(mission, 1.1)));
}

TEST(Mission, IsTheSameForTheSameSeedAndAnyThreads) {
  const auto scene = TwoRoomsScene();
  const auto run = [&](int threads, std::uint64_t seed) {
    drivers::SimulatedRobotOptions robot_options = QuickRobot();
    robot_options.threads = threads;
    drivers::SimulatedRobot robot(scene, robot_options, seed);
    MissionOptions options = QuickMission();
    options.mapper.icp.threads = threads;
    options.limits.max_scans = 4;
    return RunMission(robot, options, seed);
  };
  const MissionResult one = run(1, 5);
  ExpectSameStops(one, run(2, 5));
  EXPECT_NE(one.stops[1].T_map_base.translation, run(1, 6).stops[1].T_map_base.translation);
}

TEST(Mission, ResumedFromItsLogIsTheSameMission) {
  const auto scene = TwoRoomsScene();
  slam::testing_support::TemporaryFolder folder;
  const std::filesystem::path path = folder / "robot.log";
  MissionOptions options = QuickMission();
  options.limits.max_scans = 4;
  MissionResult undisturbed;
  {
    drivers::SimulatedRobot robot(scene, QuickRobot(), 3);
    drivers::RobotLogWriter log(path);
    drivers::RecordingRobot recording(robot, log);
    undisturbed = RunMission(recording, options, 3);
  }
  const auto size = std::filesystem::file_size(path);
  for (const double share : {0.03, 0.41, 0.77, 0.999}) {
    const std::filesystem::path cut = folder / "cut.log";
    std::filesystem::copy_file(path, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    drivers::SimulatedRobot robot(scene, QuickRobot(), 3);
    drivers::RobotLog old = drivers::ReadRobotLog(cut);
    drivers::FastForward(robot, old);
    drivers::RobotLogWriter more(cut);
    drivers::ReplayRobot resumed(old,
                                 {[&]() -> drivers::Robot& { return robot; }, drivers::Seam::kNone, &more});
    ExpectSameStops(RunMission(resumed, options, 3), undisturbed);
  }
}

TEST(Mission, StopsWhenItIsToldTo) {
  drivers::SimulatedRobot robot(TwoRoomsScene(), QuickRobot(), 1);
  MissionEvents events;
  events.stop = [&] { return robot.Now() > 5.0; };
  const MissionResult result = RunMission(robot, QuickMission(), 1, events);
  EXPECT_EQ(result.end, MissionEnd::kStopped);
  EXPECT_NEAR(robot.State().velocity.forward, 0.0, 1e-9);
  EXPECT_NEAR(robot.State().velocity.turning, 0.0, 1e-9);
  EXPECT_LT(robot.Now(), 12.0) << "braking, and no further scan than that under way";
}

/// Refuses its second scan because of its emergency stop.
class RefusingRobot : public drivers::SimulatedRobot {
 public:
  using SimulatedRobot::SimulatedRobot;
  slam::Scan TakeScan() override {
    if (scans_++ > 0) {
      refused_ = true;
      throw drivers::EmergencyStopped("nothing is scanned");
    }
    return SimulatedRobot::TakeScan();
  }
  bool refused() const { return refused_; }

 private:
  int scans_ = 0;
  bool refused_ = false;
};

/// Whether somebody stops the mission between the end of a drive and a scan, which no question sees.
TEST(Mission, IsStoppedWhereItsRobotIs) {
  RefusingRobot stopped(TwoRoomsScene(), QuickRobot(), 1);
  MissionEvents events;
  events.stop = [&] { return stopped.refused(); };
  const MissionResult result = RunMission(stopped, QuickMission(), 1, events);
  EXPECT_EQ(result.end, MissionEnd::kStopped);
  EXPECT_EQ(result.stops.size(), 1U);
  RefusingRobot broken(TwoRoomsScene(), QuickRobot(), 1);  // stopped by nobody who is known
  EXPECT_THROW(RunMission(broken, QuickMission(), 1), drivers::EmergencyStopped);
}

TEST(Mission, DrivesOnlyWhatIsApproved) {
  drivers::SimulatedRobot robot(TwoRoomsScene(), QuickRobot(), 1);
  MissionEvents events;
  events.approve = [](const PlannedDrive&) { return false; };
  const MissionResult result = RunMission(robot, QuickMission(), 1, events);
  EXPECT_EQ(result.end, MissionEnd::kRejected);
  EXPECT_EQ(result.distance, 0.0);
}

TEST(Mission, KeepsInsideItsFenceAndReturns) {
  drivers::SimulatedRobot robot(TwoRoomsScene(), QuickRobot(), 1);
  MissionOptions options = QuickMission();
  options.return_to_start = true;
  options.limits.fence = "-1.3 -2.3, 2.5 -2.3, 2.5 2.3, -1.3 2.3";  // the first room, seen from the start
  const MissionResult result = RunMission(robot, options, 1);
  for (const Eigen::Vector2d& p_map : result.path_map) EXPECT_LT(p_map.x(), 2.4);
  EXPECT_TRUE(result.returned) << Describe(result.end);
}

TEST(Mission, RefusesHeightsAndFencesThatAreNone) {
  drivers::SimulatedRobot robot(TwoRoomsScene(), QuickRobot(), 1);
  MissionOptions options = QuickMission();
  options.heights = "1.5, high";
  EXPECT_THAT(ErrorOf([&] { RunMission(robot, options, 1); }), HasSubstr("heights"));
  options.heights = "1.5";
  options.limits.fence = "0 0, 1 1";
  EXPECT_THAT(ErrorOf([&] { RunMission(robot, options, 1); }), HasSubstr("three corners"));
}

TEST(FencePosts, StandCloseAllAround) {
  const std::vector<Eigen::Vector2d> posts = FencePosts("0 0, 2 0, 2 1", 0.1);
  EXPECT_TRUE(FencePosts("", 0.1).empty());
  ASSERT_GT(posts.size(), 50U);
  for (std::size_t i = 0; i < posts.size(); ++i)
    EXPECT_LE((posts[i] - posts[(i + 1) % posts.size()]).norm(), 0.1 + 1e-9);
}

}  // namespace
}  // namespace ariadne::experiments
