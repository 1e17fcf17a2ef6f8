#include "slam/io/uos_pose.h"

#include <gmock/gmock.h>

#include "slam/base/random.h"
#include "slam/io/uos_axes.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

Pose3 RandomPose(RandomStream& stream) {
  Pose3::Tangent tau;
  for (double& component : tau) component = DrawUniform(stream, -3.0, 3.0);
  return Pose3::Exp(tau);
}

TEST(UosPose, ReadsAPoseFile) {
  const Pose3 pose = ReadText("-3.10605 -7.50803 156.917\n1.35694 -0.852409 -0.56224\n\n", ReadUosPose);
  EXPECT_TRUE(pose.translation.isApprox(Eigen::Vector3d(1.56917, 0.0310605, -0.0750803), 1e-14));
  const UosPose again = ToUosPose(pose);
  EXPECT_TRUE(again.euler_deg.isApprox(Eigen::Vector3d(1.35694, -0.852409, -0.56224), 1e-12));
}

TEST(UosPose, RoundTripsWithTheSameBytes) {
  RandomStream stream = NamedStream(1, "uos_pose_test");
  for (int i = 0; i < 1000; ++i) {
    const Pose3 pose = RandomPose(stream);
    const std::string written = Written(WriteUosPose, pose);
    const Pose3 read = ReadText(written, ReadUosPose);
    EXPECT_LT(TranslationDistance(read, pose), 1e-10);
    EXPECT_LT(RotationDistance(read, pose), 1e-11);
    ASSERT_EQ(Written(WriteUosPose, read), written);
  }
}

TEST(UosPose, WritesPlainNumbers) {
  EXPECT_EQ(Written(WriteUosPose, Pose3()), "0 0 0\n0 0 0\n");
  const Pose3 turned = FromUosPose({{100.0, -2.5, 0.0}, {0.0, 90.0, 0.0}});
  EXPECT_EQ(Written(WriteUosPose, turned), "100 -2.5 0\n0 90 0\n");
}

TEST(UosPose, RefusesDamagedFiles) {
  EXPECT_THAT(ErrorOfText("", ReadUosPose), HasSubstr("file:1: the file ends before the position"));
  EXPECT_THAT(ErrorOfText("1 2 3\n", ReadUosPose),
              HasSubstr("file:2: the file ends before the Euler angles"));
  EXPECT_THAT(ErrorOfText("1 2\n1 2 3\n", ReadUosPose), HasSubstr("file:1: found 2 numbers, expected 3"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 nan 3\n", ReadUosPose),
              HasSubstr("file:2: a number is NaN or infinite"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 2 3\n1\n", ReadUosPose), HasSubstr("file:3: found '1' after the end"));
}

TEST(UosFrames, ReadsMatricesColumnByColumn) {
  // A yaw of -90 deg (uos: +90 deg about y), 3 m ahead and 1 m to the right.
  const auto frames = ReadText("0 0 -1 0 0 1 0 0 1 0 0 0 100 0 300 1 2\n", ReadUosFrames);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].type, 2);
  const Pose3 expected = FromUosPose({{100.0, 0.0, 300.0}, {0.0, 90.0, 0.0}});
  EXPECT_LT(TranslationDistance(frames[0].T_map_laser, expected), 1e-14);
  EXPECT_LT(RotationDistance(frames[0].T_map_laser, expected), 1e-14);
}

TEST(UosFrames, RoundTripsWithTheSameBytes) {
  RandomStream stream = NamedStream(2, "uos_pose_test");
  std::vector<UosFrame> frames;
  for (int i = 0; i < 1000; ++i) frames.push_back({RandomPose(stream), i % 5});
  const std::string written = Written(WriteUosFrames, frames);
  const auto read = ReadText(written, ReadUosFrames);
  ASSERT_EQ(read.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_LT(TranslationDistance(read[i].T_map_laser, frames[i].T_map_laser), 1e-10);
    EXPECT_LT(RotationDistance(read[i].T_map_laser, frames[i].T_map_laser), 1e-13);
    EXPECT_EQ(read[i].type, frames[i].type);
  }
  EXPECT_EQ(Written(WriteUosFrames, read), written);
}

TEST(UosFrames, WritesASingleFrameTwice) {
  const std::vector<UosFrame> frames{{Pose3(), UosFrame::kIcp}};
  EXPECT_EQ(Written(WriteUosFrames, frames),
            "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1\n1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1\n");
}

TEST(UosFrames, RefusesDamagedFiles) {
  const std::string good = "1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1 1\n";
  EXPECT_THAT(ErrorOfText("", ReadUosFrames), HasSubstr("file: holds no frames"));
  EXPECT_THAT(ErrorOfText(good + "1 2 3\n", ReadUosFrames),
              HasSubstr("file:2: found 3 numbers, expected 17"));
  EXPECT_THAT(ErrorOfText(good + "\n" + good, ReadUosFrames), HasSubstr("file:2: the line is empty"));
  EXPECT_THAT(ErrorOfText("2 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1 1\n", ReadUosFrames),
              HasSubstr("not a rigid motion"));
  EXPECT_THAT(ErrorOfText("1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1 1\n", ReadUosFrames),
              HasSubstr("not a rigid motion"));
  EXPECT_THAT(ErrorOfText("1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1 1.5\n", ReadUosFrames),
              HasSubstr("whole number"));
  EXPECT_THAT(ErrorOfText("1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1 1e30\n", ReadUosFrames),
              HasSubstr("whole number"));
}

}  // namespace
}  // namespace ariadne::slam
