#include "experiments/studies/person_contact.h"

#include <gtest/gtest.h>

#include <numbers>

#include "drivers/simulated/solids.h"
#include "experiments/mission/mission_options.h"
#include "experiments/mission/simulated_mission.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

/// A post of 40 cm that comes along a line from some time on, at the origin after 10 s.
drivers::World WalkingPost(const Eigen::Vector2d& velocity, double from = 0.0) {
  drivers::World world;
  const slam::Box3 post(Eigen::Vector3d(-0.2, -0.2, 0.0), Eigen::Vector3d(0.2, 0.2, 1.8));
  drivers::Body body{"post", drivers::MakeBox(post), {}, {}};
  for (const double time : {from, 20.0}) {
    body.motion.times.push_back(time);
    body.motion.T_map_body.push_back(slam::ToPose3(Pose2{0.0, (time - 10.0) * velocity}));
  }
  world.bodies.push_back(std::move(body));
  return world;
}

TEST(HasInView, KnowsWhatStandsBetweenTheFieldsOfView) {
  const drivers::RayScene scene(WalkingPost({1.0, 0.0}));
  const auto robot = MissionRobotOptions();
  const auto sees = [&](const Pose2& T_map_base) {
    return HasInView(scene, T_map_base, 10.0, "post", robot);
  };
  EXPECT_TRUE(sees({0.0, {-2.0, 0.0}})) << "ahead";
  EXPECT_TRUE(sees({0.0, {2.0, 0.0}})) << "behind";
  EXPECT_FALSE(sees({0.0, {0.0, 2.0}})) << "beside";
  EXPECT_FALSE(HasInView(scene, {0.0, {-2.0, 0.0}}, 10.0, "another", robot));
}

/// Contact at 10 s of a robot that drives ahead at 0.8 m/s to where the post is.
ContactVerdict VerdictOf(const Eigen::Vector2d& velocity, double from = 0.0) {
  const drivers::RayScene scene(WalkingPost(velocity, from));
  std::vector<drivers::TruePose> path;
  for (int i = 0; i <= 1000; ++i) {
    const double time = 0.01 * i;
    path.push_back({time, {0.0, {-0.6 + 0.8 * (time - 10.0), 0.0}}});
  }
  const DriveOptions drive = RobotDriveOptions();
  return JudgeContact({10.0, path.back().T_map_base, "post"}, path, scene, MissionRobotOptions(), drive);
}

TEST(JudgeContact, TellsWhatARobotCouldHaveDone) {
  const ContactVerdict across = VerdictOf({0.0, 1.0});
  EXPECT_TRUE(across.needless) << "it crosses: who stands before its way is not touched";
  EXPECT_TRUE(across.foreseeable);
  EXPECT_FALSE(VerdictOf({0.0, 1.0}, 8.5).foreseeable) << "it stood when the brakes had to be put on";
  EXPECT_FALSE(VerdictOf({0.0, 1.0}, 8.2).foreseeable) << "nobody knew yet that it walks";
  EXPECT_TRUE(VerdictOf({0.0, 1.0}, 7.9).foreseeable);
  const ContactVerdict against = VerdictOf({-2.0, 0.0});
  EXPECT_FALSE(against.needless) << "it comes all the same";
  EXPECT_TRUE(against.foreseeable) << "it could have stood";
}

}  // namespace
}  // namespace ariadne::experiments
