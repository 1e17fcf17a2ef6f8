#include "slam/io/kitti.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

TEST(Kitti, RoundTripsWithTheSameBytes) {
  PointCloud cloud = SmallCloud();
  cloud.reflectance = {0.0F, 0.5F, 0.25F};
  const std::string written = Written(WriteKitti, cloud);
  EXPECT_EQ(written.size(), 48U);
  const PointCloud read = ReadText(written, ReadKitti);
  ExpectEqual(read, cloud);
  EXPECT_EQ(Written(WriteKitti, read), written);
}

TEST(Kitti, ReadsMoreThanOneBlock) {
  PointCloud cloud;
  for (int i = 0; i < 200'000; ++i) cloud.positions.emplace_back(i, -i, 0.5 * i);
  cloud.reflectance.assign(cloud.size(), 1.0F);
  ExpectEqual(ReadText(Written(WriteKitti, cloud), ReadKitti), cloud);
}

TEST(Kitti, RefusesDamagedFiles) {
  const std::string good = Written(WriteKitti, SmallCloud());
  EXPECT_EQ(ErrorOfText("", ReadKitti), "file: is empty; expected records of 16 bytes");
  EXPECT_THAT(ErrorOfText(good.substr(0, 40), ReadKitti),
              HasSubstr("file: byte 40: the file ends in point 3, of 16 bytes; it is truncated"));
  std::string bad = good;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bad.replace(20, sizeof(nan), reinterpret_cast<const char*>(&nan), sizeof(nan));
  EXPECT_THAT(ErrorOfText(bad, ReadKitti),
              HasSubstr("file: byte 16: point 2 has a coordinate that is NaN"));
}

TEST(Kitti, RefusesWhatDoesNotFitAFloat) {
  PointCloud cloud = SmallCloud();
  cloud.positions[2].x() = 1e39;
  EXPECT_THAT(ErrorOf([&] { Written(WriteKitti, cloud); }),
              HasSubstr("the coordinate 1e+39 m does not fit"));
  EXPECT_THAT(ErrorOf([] { Written(WriteKitti, PointCloud()); }), HasSubstr("without points"));
}

}  // namespace
}  // namespace ariadne::slam
