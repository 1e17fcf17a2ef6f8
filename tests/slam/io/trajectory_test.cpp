#include "slam/io/trajectory.h"

#include <gmock/gmock.h>

#include "slam/base/random.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

std::vector<Pose3> RandomPoses(int count, const char* name) {
  RandomStream stream = NamedStream(5, name);
  std::vector<Pose3> poses;
  for (int i = 0; i < count; ++i) {
    Pose3::Tangent tau;
    for (double& component : tau) component = DrawUniform(stream, -3.0, 3.0);
    poses.push_back(Pose3::Exp(tau));
  }
  return poses;
}

void ExpectNear(const Pose3& a, const Pose3& b) {
  EXPECT_EQ(a.translation, b.translation);
  EXPECT_LT(RotationDistance(a, b), 1e-13);
}

TEST(Tum, ReadsAllDigitsBack) {
  std::vector<StampedPose> poses;
  for (const Pose3& pose : RandomPoses(1000, "tum")) {
    poses.push_back({1.6e9 + 0.1 * static_cast<double>(poses.size()), pose});
  }
  const auto read = ReadText(Written(WriteTum, poses), ReadTum);
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(read[i].stamp, poses[i].stamp);
    EXPECT_EQ(read[i].pose.translation, poses[i].pose.translation);
    EXPECT_EQ(read[i].pose.rotation.coeffs(), poses[i].pose.rotation.coeffs());
  }
}

TEST(Tum, ReadsByHand) {
  const auto read = ReadText("# stamp tx ty tz qx qy qz qw\r\n2.5 1 2 3 0 0 0.7071 0.7071\r\n\n", ReadTum);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].stamp, 2.5);
  EXPECT_TRUE((read[0].pose * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, 3, 3), 1e-12));
  EXPECT_NEAR(read[0].pose.rotation.norm(), 1.0, 1e-15);
}

TEST(Tum, RefusesDamagedFiles) {
  const std::string good = "0 1 2 3 0 0 0 1\n";
  EXPECT_EQ(ErrorOfText("# none\n", ReadTum), "file: holds no poses; expected one per line");
  EXPECT_THAT(ErrorOfText(good + "0 1 2 3 0 0 0\n", ReadTum),
              HasSubstr("file:2: found 7 numbers, expected 8 (stamp"));
  EXPECT_THAT(ErrorOfText(good + "\n" + good, ReadTum),
              HasSubstr("file:2: the line is empty where a pose"));
  EXPECT_THAT(ErrorOfText(good + "0 nan 2 3 0 0 0 1\n", ReadTum),
              HasSubstr("file:2: a number is NaN or infinite"));
  EXPECT_THAT(ErrorOfText("0 1 2 3 0 0 0 1.01\n", ReadTum),
              HasSubstr("file:1: the quaternion has length 1.01"));
  EXPECT_THAT(ErrorOfText("0 1 2 3 0 0 0 1x\n", ReadTum), HasSubstr("file:1: '1x' is not a number"));
}

TEST(KittiPoses, RoundTripsWithTheSameBytes) {
  const std::vector<Pose3> poses = RandomPoses(1000, "kitti");
  const std::string written = Written(WriteKittiPoses, poses);
  const auto read = ReadText(written, ReadKittiPoses);
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) ExpectNear(read[i], poses[i]);
  EXPECT_EQ(Written(WriteKittiPoses, read), written);
  const auto again = ReadText(written, ReadKittiPoses);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(again[i].rotation.coeffs(), read[i].rotation.coeffs());
  }
}

TEST(KittiPoses, ReadsRowByRow) {
  const auto read = ReadText("0 -1 0 10 1 0 0 20 0 0 1 30", ReadKittiPoses);
  EXPECT_TRUE((read[0] * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(10, 21, 30), 1e-12));
}

TEST(KittiPoses, RefusesDamagedFiles) {
  const std::string good = "1 0 0 1 0 1 0 2 0 0 1 3\n";
  EXPECT_THAT(ErrorOfText(good + "1 0 0 1 0 1 0 2 0 0 1\n", ReadKittiPoses),
              HasSubstr("file:2: found 11 numbers"));
  EXPECT_THAT(ErrorOfText("1 0 0 1 0 1.01 0 2 0 0 1 3\n", ReadKittiPoses),
              HasSubstr("file:1: the matrix is not a rota"));
  EXPECT_THAT(ErrorOfText("1 0 0 1 0 1 0 2 0 0 -1 3\n", ReadKittiPoses),
              HasSubstr("file:1: the matrix is not a rota"));
  EXPECT_THAT(ErrorOfText(good + " \n\n" + good, ReadKittiPoses), HasSubstr("file:2: the line is empty"));
}

TEST(PoseList, RoundTripsWithTheSameBytes) {
  std::vector<NamedPose> poses;
  for (const Pose3& pose : RandomPoses(100, "list")) {
    poses.push_back({"scan" + std::to_string(poses.size()), pose});
  }
  const std::string written = Written(WritePoseList, poses);
  const auto read = ReadText(written, ReadPoseList);
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(read[i].name, poses[i].name);
    ExpectNear(read[i].pose, poses[i].pose);
  }
  EXPECT_EQ(Written(WritePoseList, read), written);
}

TEST(PoseList, HasNamesOnAllLinesOrNone) {
  const std::string matrix = "1 0 0 1 0 1 0 2 0 0 1 3\n";
  EXPECT_EQ(ReadText("000 " + matrix, ReadPoseList).front().name, "000");
  EXPECT_EQ(ReadText(matrix, ReadPoseList).front().name, "");
  EXPECT_THAT(ErrorOfText("000 " + matrix + matrix, ReadPoseList), HasSubstr("file:2: found 11 numbers"));
  EXPECT_THAT(ErrorOfText(matrix + "001 " + matrix, ReadPoseList), HasSubstr("file:2: found 13 numbers"));
  EXPECT_THAT(ErrorOf([] {
                Written(WritePoseList, std::vector<NamedPose>{{"two words", Pose3()}});
              }),
              HasSubstr("a name must be one word"));
}

TEST(AnyPoses, AreToldFromTheirColumns) {
  const std::string matrix = "1 0 0 1 0 1 0 2 0 0 1 3\n";
  for (const std::string& text :
       std::initializer_list<std::string>{"# TUM\n5.5 1 2 3 0 0 0 1\n", matrix, "007 " + matrix}) {
    EXPECT_EQ(ReadText(text, ReadAnyPoses).front().pose.translation, Eigen::Vector3d(1, 2, 3));
  }
  EXPECT_THAT(ErrorOfText("# a comment\n1 2 3\n", ReadAnyPoses),
              HasSubstr("file:2: found 3 columns, expected 8"));
  EXPECT_THAT(ErrorOfText("", ReadAnyPoses), HasSubstr("file: holds no poses"));
}

TEST(Trajectories, RefuseToWriteWhatCannotBeRead) {
  Pose3 pose;
  pose.translation.x() = std::nan("");
  EXPECT_THAT(ErrorOf([&] { Written(WriteKittiPoses, std::vector{pose}); }), HasSubstr("NaN or infinite"));
  EXPECT_THAT(ErrorOf([&] { Written(WriteTum, std::vector{StampedPose{0.0, pose}}); }), HasSubstr("NaN"));
  EXPECT_THAT(ErrorOf([&] {
                Written(WriteTum, std::vector{StampedPose{INFINITY, Pose3()}});
              }),
              HasSubstr("stamp"));
  const Pose3 zero{Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0), Eigen::Vector3d::Zero()};
  EXPECT_THAT(ErrorOf([&] { Written(WriteKittiPoses, std::vector{zero}); }),
              HasSubstr("quaternion has length 0"));
}

}  // namespace
}  // namespace ariadne::slam
