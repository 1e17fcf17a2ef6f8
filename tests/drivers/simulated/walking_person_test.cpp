#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/differential_frames.h"
#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/safety_scanners.h"
#include "slam/base/random.h"
#include "tests/drivers/simulated/box_room.h"

// Differential frames in a furnished room of 8 x 6 m, the noise of the devices on (Sec. 3.4).
namespace ariadne::drivers {
namespace {

constexpr double kRobotRadius = 0.7;  // nobody walks closer to the robot's middle [m]

struct Case {
  World world = FurnishedRoom();
  slam::Pose2 T_map_base;
};

slam::Pose3 InPlane(const slam::Pose2& pose) { return slam::ToPose3(pose); }

slam::Pose2 DrawRobot(RandomStream& stream) {
  return {DrawUniform(stream, -std::numbers::pi, std::numbers::pi),
          {DrawUniform(stream, -1.0, 1.0), DrawUniform(stream, -1.0, 1.0)}};
}

/// A straight way through the room that keeps clear of the robot.
std::pair<Eigen::Vector2d, Eigen::Vector2d> DrawWay(RandomStream& stream, const Eigen::Vector2d& robot) {
  for (;;) {
    const Eigen::Vector2d from(DrawUniform(stream, -3.7, 3.7), DrawUniform(stream, -2.7, 2.7));
    const double heading = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
    const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
    const Eigen::Vector2d to = from + 2.5 * along;
    const double passing = std::clamp((robot - from).dot(along), 0.0, 2.5);
    const bool clear = (from + passing * along - robot).norm() > kRobotRadius;
    if (clear && std::abs(to.x()) < 3.7 && std::abs(to.y()) < 2.7) return {from, to};
  }
}

/// Two legs, each a box on the ground that takes steps of 0.7 m in turn, and a body over them.
void AddPerson(Case& c, RandomStream& stream) {
  const auto [from, to] = DrawWay(stream, c.T_map_base.translation);
  const double speed = DrawUniform(stream, 0.6, 1.6);
  const double start = DrawUniform(stream, 0.0, 2.0);
  const Eigen::Vector2d along = (to - from).normalized();
  const double heading = std::atan2(along.y(), along.x());
  for (const double side : {-1.0, 1.0}) {
    Body leg = BoxBody("leg", {-0.1, -0.07 + 0.12 * side, 0.0}, {0.1, 0.07 + 0.12 * side, 0.9});
    for (int step = 0; step <= 8; ++step) {
      const double lead = (step % 2 == 0 ? 0.17 : -0.17) * side;
      const double way = std::clamp(2.5 * step / 8.0 + lead, 0.0, 2.5);
      leg.motion.times.push_back(start + 2.5 * step / 8.0 / speed);
      leg.motion.T_map_body.push_back(InPlane({heading, from + way * along}));
    }
    c.world.bodies.push_back(leg);
  }
  Body torso = BoxBody("torso", {-0.15, -0.25, 0.9}, {0.15, 0.25, 1.8});
  torso.motion.times = {start, start + 2.5 / speed};
  torso.motion.T_map_body = {InPlane({heading, from}), InPlane({heading, to})};
  c.world.bodies.push_back(torso);
}

/// Whether the frames that are taken during one 3D scan differ.
bool SeesMotion(const Case& c, std::uint64_t seed) {
  const DifferentialFrameOptions options;
  const RayScene scene(c.world);
  const Motion base = Standing(slam::ToPose3(c.T_map_base));
  std::vector<std::vector<SafetySweep>> frames;
  for (double time = 0.0; time <= AisScanDuration({}); time += options.period) {
    frames.push_back(TakeSafetySweeps(scene, base, time, {}, seed, frames.size()));
  }
  return !DetectMotion(frames, options).empty();
}

TEST(DifferentialFrames, DetectAPersonWhoWalksThroughAScan) {
  constexpr std::uint64_t kCases = 100;
  std::size_t detected = 0;
  for (std::uint64_t seed = 0; seed < kCases; ++seed) {
    RandomStream stream = NamedStream(seed, "walking_person_test");
    Case c;
    c.T_map_base = DrawRobot(stream);
    AddPerson(c, stream);
    detected += SeesMotion(c, seed);
  }
  EXPECT_GE(detected, 95u) << "of " << kCases;
}

TEST(DifferentialFrames, RaiseNoAlarmWhereNothingMoves) {
  constexpr std::uint64_t kCases = 200;
  std::size_t alarms = 0;
  for (std::uint64_t seed = 0; seed < kCases; ++seed) {
    RandomStream stream = NamedStream(seed, "static_room_test");
    Case c;
    c.T_map_base = DrawRobot(stream);
    alarms += SeesMotion(c, seed);
  }
  EXPECT_LE(alarms, 4u) << "of " << kCases;
}

}  // namespace
}  // namespace ariadne::drivers
