#include "slam/io/initial_poses.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

/// Three scans without poses.
class InitialPosesTest : public testing::Test {
 protected:
  InitialPosesTest() {
    for (const char* name : {"scans/scan0.3d", "scans/scan1.3d", "scans/scan02.3d"}) {
      folder_.Write(name, "");
    }
  }

  InitialPoses Read(const std::optional<fs::path>& path = std::nullopt) const {
    return ReadInitialPoses(ListScans(folder_ / "scans"), path).value();
  }
  std::string Refusal(const std::optional<fs::path>& path = std::nullopt) const {
    return ErrorOf([&] { Read(path); });
  }
  static std::vector<double> X(const InitialPoses& poses) {
    std::vector<double> x;
    for (const Pose3& pose : poses.T_map_laser) x.push_back(pose.translation.x());
    return x;
  }

  TemporaryFolder folder_;
};

std::string Matrix(int x) { return "1 0 0 " + std::to_string(x) + " 0 1 0 0 0 0 1 0\n"; }
std::string Frame(int z_cm) { return "1 0 0 0 0 1 0 0 0 0 1 0 0 0 " + std::to_string(z_cm) + " 1 1\n"; }

TEST_F(InitialPosesTest, MayBeMissing) {
  EXPECT_FALSE(ReadInitialPoses(ListScans(folder_ / "scans")).has_value());
}

TEST_F(InitialPosesTest, ComeFromPoseFiles) {
  folder_.Write("scans/scan0.pose", "0 0 0\n0 0 0\n");
  folder_.Write("scans/scan1.pose", "0 0 100\n0 0 0\n");
  EXPECT_THAT(Refusal(), HasSubstr("scan02.pose: is missing, while other scans have one"));
  folder_.Write("scans/scan02.pose", "0 0 200\n0 0 0\n");
  folder_.Write("scans/poses.txt", "not read");
  EXPECT_THAT(X(Read()), ElementsAre(0.0, 1.0, 2.0));
  EXPECT_THAT(Read().source, HasSubstr(".pose files in "));
}

TEST_F(InitialPosesTest, ComeFromTheLastFrames) {
  folder_.Write("scans/scan0.frames", Frame(0) + Frame(0));
  folder_.Write("scans/scan1.frames", Frame(50) + Frame(100));
  folder_.Write("scans/scan02.frames", Frame(100) + Frame(200));
  EXPECT_THAT(X(Read()), ElementsAre(0.0, 1.0, 2.0));
}

TEST_F(InitialPosesTest, ComeFromAFileBesideOrAbove) {
  folder_.Write("initial_poses.txt", Matrix(4) + Matrix(5) + Matrix(6));
  EXPECT_THAT(X(Read()), ElementsAre(4.0, 5.0, 6.0));
  EXPECT_EQ(Read().source, (folder_ / "initial_poses.txt").string());
  folder_.Write("scans/trajectory.tum", "0 7 0 0 0 0 0 1\n1 8 0 0 0 0 0 1\n2 9 0 0 0 0 0 1\n");
  EXPECT_THAT(X(Read()), ElementsAre(7.0, 8.0, 9.0));
}

TEST_F(InitialPosesTest, AreFoundAboveAFolderWithASlash) {
  folder_.Write("poses.txt", Matrix(4) + Matrix(5) + Matrix(6));
  const ScanList list = ListScans(folder_ / "scans/");
  EXPECT_EQ(ReadInitialPoses(list)->source, (folder_ / "poses.txt").string());
}

TEST_F(InitialPosesTest, ComeFromAnExplicitFileBeforeAll) {
  folder_.Write("scans/scan0.pose", "not read");
  const fs::path path = folder_.Write("other", Matrix(1) + Matrix(2) + Matrix(3));
  EXPECT_THAT(X(Read(path)), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(Refusal(folder_ / "none"), HasSubstr("none: there is no such file"));
}

TEST_F(InitialPosesTest, AreMatchedByName) {
  const fs::path path = folder_.Write(
      "other", "scan1 " + Matrix(1) + "2 " + Matrix(2) + "7 " + Matrix(7) + "000 " + Matrix(0));
  EXPECT_THAT(X(Read(path)), ElementsAre(0.0, 1.0, 2.0));
  folder_.Write("other", "0 " + Matrix(0) + "2 " + Matrix(2));
  EXPECT_THAT(Refusal(path), HasSubstr("other: has no pose for scan1"));
  folder_.Write("other", "0 " + Matrix(0) + "1 " + Matrix(1) + "2 " + Matrix(2) + "01 " + Matrix(1));
  EXPECT_THAT(Refusal(path), HasSubstr("other: has more than one pose for scan1"));
}

TEST_F(InitialPosesTest, WithoutKnownNamesAreMatchedByPlace) {
  const fs::path path =
      folder_.Write("other", "17.5 " + Matrix(1) + "18.5 " + Matrix(2) + "19.5 " + Matrix(3));
  EXPECT_THAT(X(Read(path)), ElementsAre(1.0, 2.0, 3.0));
}

TEST_F(InitialPosesTest, MustBeAsManyAsScans) {
  const fs::path path = folder_.Write("other", Matrix(0) + Matrix(1));
  EXPECT_THAT(Refusal(path), HasSubstr("other: holds 2 poses for 3 scans; scan02 has none"));
  folder_.Write("other", Matrix(0) + Matrix(1) + Matrix(2) + Matrix(3));
  EXPECT_THAT(Refusal(path), HasSubstr("other: holds 4 poses for 3 scans, the last of which is scan02"));
}

}  // namespace
}  // namespace ariadne::slam
