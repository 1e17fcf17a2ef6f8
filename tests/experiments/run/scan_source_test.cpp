#include "experiments/run/scan_source.h"
#include "experiments/run/data_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using slam::testing_support::ErrorOf;
using slam::testing_support::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three scans of one point, (i, 0, 0), at the poses (10 i, 0, 0).
class ScanSourceTest : public testing::Test {
 protected:
  ScanSourceTest() {
    for (int i = 0; i < 3; ++i) {
      folder_.Write("scan" + std::to_string(i) + ".xyz", std::to_string(i) + " 0 0\n");
    }
    folder_.Write("poses.txt", "0 0 0 0 0 0 0 1\n1 10 0 0 0 0 0 1\n2 20 0 0 0 0 0 1\n");
    options_.folder = folder_.path().string();
  }
  std::string ErrorOfOpening() const {
    return ErrorOf([&] { ScanSource source(options_); });
  }
  TemporaryFolder folder_;
  InputOptions options_;
};

TEST_F(ScanSourceTest, ReadsScansAtTheirPoses) {
  const ScanSource source(options_);
  ASSERT_EQ(source.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const slam::PosedCloud scan = source.Read(i);
    EXPECT_EQ(scan.name, "scan" + std::to_string(i));
    EXPECT_EQ(source.name(i), scan.name);
    EXPECT_EQ(scan.cloud_laser.positions.at(0), Eigen::Vector3d(static_cast<double>(i), 0.0, 0.0));
    EXPECT_EQ(scan.T_map_laser.translation.x(), 10.0 * static_cast<double>(i));
    EXPECT_EQ(source.T_odom_laser(i).translation.x(), 10.0 * static_cast<double>(i));
    EXPECT_FALSE(source.truth(i).has_value());
  }
  EXPECT_THAT(source.Files(),
              ElementsAre(folder_ / "scan0.xyz", folder_ / "scan1.xyz", folder_ / "scan2.xyz"));
  EXPECT_THAT(source.notes(), ElementsAre(HasSubstr((folder_ / "poses.txt").string())));
}

TEST_F(ScanSourceTest, TakesAPartOfTheScans) {
  options_.first = options_.last = 1;
  const ScanSource one(options_);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.name(0), "scan1");
  EXPECT_EQ(one.T_odom_laser(0).translation.x(), 10.0);
  EXPECT_EQ(one.Read(0).cloud_laser.positions[0].x(), 1.0);
  options_.last = -1;
  EXPECT_EQ(ScanSource(options_).size(), 2U) << "to the end";
}

TEST_F(ScanSourceTest, RefusesAPartThatIsNotThere) {
  for (const auto& [first, last] : {std::pair(0, 3), {3, -1}, {2, 1}}) {
    options_.first = first;
    options_.last = last;
    EXPECT_THAT(ErrorOfOpening(), HasSubstr("input.first, input.last), but there are 0 to 2"));
  }
  options_.first = -1;
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("input.first is -1"));
}

TEST_F(ScanSourceTest, TakesThePosesThatItIsGiven) {
  options_.poses = folder_.Write("other/guess.tum", "0 1 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n");
  EXPECT_EQ(ScanSource(options_).T_odom_laser(2).translation.x(), 3.0);
  options_.poses = (folder_ / "none.tum").string();
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("none.tum: there is no such file"));
}

TEST_F(ScanSourceTest, SaysThatThereAreNoPoses) {
  std::filesystem::remove(folder_ / "poses.txt");
  const ScanSource source(options_);
  EXPECT_TRUE(source.T_odom_laser(2).translation.isZero());
  EXPECT_THAT(source.notes(), ElementsAre(HasSubstr("all start at the identity")));
}

TEST_F(ScanSourceTest, TakesOneOfTwoFormats) {
  folder_.Write("scan0.3d", "100 200 300\n");
  EXPECT_THAT(ErrorOfOpening(), AllOf(HasSubstr("xyz"), HasSubstr("uos"), HasSubstr("--format")));
  options_.format = InputFormat::kUos;
  std::filesystem::remove(folder_ / "poses.txt");
  const ScanSource source(options_);
  ASSERT_EQ(source.size(), 1U);
  EXPECT_EQ(source.Read(0).cloud_laser.positions[0], Eigen::Vector3d(3.0, -1.0, 2.0))
      << "uos is (-y, z, x)";
}

TEST_F(ScanSourceTest, ReadsAScanOnlyWhenItIsAskedFor) {
  folder_.Write("scan1.xyz", "1 2 3\n1 nan 3\n");
  const ScanSource source(options_);
  EXPECT_NO_THROW(source.Read(0));
  EXPECT_THAT(ErrorOf([&] { source.Read(1); }), HasSubstr("scan1.xyz:2: "));
}

TEST_F(ScanSourceTest, FindsTheDataOfTheEnvironment) {
  setenv("ARIADNE_DATA", folder_.path().c_str(), 1);
  EXPECT_EQ(ExpandDataPath("$ARIADNE_DATA/scans/x"), folder_ / "scans/x");
  EXPECT_EQ(ExpandDataPath("here/$ARIADNE_DATA"), "here/$ARIADNE_DATA");
  setenv("ARIADNE_DATA", (folder_ / "none").c_str(), 1);
  EXPECT_THAT(
      ErrorOf([] { ExpandDataPath("$ARIADNE_DATA/scans/x"); }),
      AllOf(HasSubstr("there is no folder"), HasSubstr("set the environment variable ARIADNE_DATA")));
  unsetenv("ARIADNE_DATA");
}

TEST(BuiltInScans, NeedNoFilesAndKnowTheTruth) {
  InputOptions options;
  options.office.scans = 4;
  options.office.beams = 31;
  options.office.slices = 8;
  options.first = 2;
  const ScanSource source(options);
  ASSERT_EQ(source.size(), 2U);
  EXPECT_EQ(source.name(0), "scan002");
  EXPECT_THAT(source.Files(), IsEmpty());
  EXPECT_EQ(source.truth(1)->translation, TrueLaserPoses(options.office)[3].translation);
  EXPECT_EQ(source.T_odom_laser(1).translation, OdometryPoses(options.office)[3].translation);
  EXPECT_EQ(source.Read(1).cloud_laser.positions, ScanOffice(options.office, 3).positions);
}

}  // namespace
}  // namespace ariadne::experiments
