#include "slam/io/uos_cloud.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(UosCloud, ConvertsUnitAndAxes) {
  const PointCloud cloud = ReadText("100 200 300\n-50 0 10\n", ReadUosCloud);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_TRUE(cloud.positions[0].isApprox(Eigen::Vector3d(3.0, -1.0, 2.0), 1e-15));
  EXPECT_TRUE(cloud.positions[1].isApprox(Eigen::Vector3d(0.1, 0.5, 0.0), 1e-15));
  EXPECT_TRUE(cloud.reflectance.empty());
  EXPECT_FALSE(cloud.organized());
}

TEST(UosCloud, ReadsReflectanceAndWindowsLines) {
  const PointCloud cloud = ReadText("1 2 3 0.5\r\n\r\n4\t5 6 nan", ReadUosCloud);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.reflectance[0], 0.5F);
  EXPECT_TRUE(std::isnan(cloud.reflectance[1]));  // not measured, which the position is
}

TEST(UosCloud, TakesSlicesFromAHeaderThatFits) {
  const std::string points = "0 0 1\n0 0 2\n0 0 3\n0 0 4\n0 0 5\n0 0 6\n";
  EXPECT_THAT(ReadText("3 x 2\n" + points, ReadUosCloud).slice_begin, ElementsAre(0, 2, 4));
  EXPECT_THAT(ReadText("3 x 3\n" + points, ReadUosCloud).slice_begin, ElementsAre());
  EXPECT_THAT(ReadText("0 x 0\n" + points, ReadUosCloud).slice_begin, ElementsAre());
  EXPECT_EQ(ReadText("99999999999 x 99999999999\n" + points, ReadUosCloud).size(), 6U);
}

TEST(UosCloud, RoundTripsWithTheSameBytes) {
  PointCloud cloud = SmallCloud();
  cloud.positions.push_back({0.1234567890123, -7.0 / 3.0, 1e-9});
  cloud.slice_begin = {0, 2};
  for (const std::vector<float>& reflectance : {std::vector<float>{}, {0.1F, 2.0F, 3.5F, 1e-7F}}) {
    cloud.reflectance = reflectance;
    const std::string written = Written(WriteUosCloud, cloud);
    const PointCloud read = ReadText(written, ReadUosCloud);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_TRUE(read.positions[i].isApprox(cloud.positions[i], 1e-11));
    }
    EXPECT_EQ(read.reflectance, cloud.reflectance);
    EXPECT_EQ(read.slice_begin, cloud.slice_begin);
    EXPECT_EQ(Written(WriteUosCloud, read), written);
  }
}

TEST(UosCloud, WritesNoHeaderForUnequalSlices) {
  PointCloud cloud = SmallCloud();
  cloud.slice_begin = {0, 2};
  EXPECT_EQ(Written(WriteUosCloud, cloud), "-200 300 100\n-25 800 -50\n12.5 0 10000\n");
}

TEST(UosCloud, RefusesDamagedFiles) {
  EXPECT_EQ(ErrorOfText("", ReadUosCloud), "file: holds no points; expected lines of x y z");
  EXPECT_EQ(ErrorOfText("2 x 2\n", ReadUosCloud), "file: holds no points; expected lines of x y z");
  EXPECT_EQ(ErrorOfText("1 2 3\n4 5 6.0abc\n", ReadUosCloud), "file:2: '6.0abc' is not a number");
  EXPECT_THAT(ErrorOfText("1,0 2,0 3,0\n", ReadUosCloud), HasSubstr("file:1: '1,0' is not a number"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 2\n", ReadUosCloud), HasSubstr("file:2: found 2 numbers where"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 2 3 4\n", ReadUosCloud), HasSubstr("file:2: found 4 numbers where"));
  EXPECT_THAT(ErrorOfText("1 2 3 4 5\n", ReadUosCloud),
              HasSubstr("file:1: found 5 numbers, expected x y z or"));
  EXPECT_THAT(ErrorOfText("1 2 3\nnan 0 0\n", ReadUosCloud),
              HasSubstr("file:2: the point has a coordinate"));
  EXPECT_THAT(ErrorOfText("1 2 inf\n", ReadUosCloud), HasSubstr("file:1: the point has a coordinate"));
  EXPECT_THAT(ErrorOfText("-3 x 4\n1 2 3\n", ReadUosCloud), HasSubstr("file:1: 'x' is not a number"));
  EXPECT_THAT(ErrorOfText("1 2 3 1e300\n", ReadUosCloud), HasSubstr("reflectance that does not fit"));
}

TEST(UosCloud, RefusesToWriteWhatCannotBeRead) {
  PointCloud cloud = SmallCloud();
  EXPECT_THAT(ErrorOf([] { Written(WriteUosCloud, PointCloud()); }), HasSubstr("without points"));
  cloud.reflectance = {1.0F};
  EXPECT_THAT(ErrorOf([&] { Written(WriteUosCloud, cloud); }), HasSubstr("3 points with 1 reflectances"));
  cloud.reflectance.clear();
  cloud.positions[1].y() = std::nan("");
  EXPECT_THAT(ErrorOf([&] { Written(WriteUosCloud, cloud); }), HasSubstr("cannot write point 1"));
}

}  // namespace
}  // namespace ariadne::slam
