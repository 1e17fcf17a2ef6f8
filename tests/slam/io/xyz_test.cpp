#include "slam/io/xyz.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

TEST(Xyz, AcceptsAllSeparatorsAndComments) {
  PointCloud expected;
  expected.positions = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  for (const char* text : {"1 2 3\n4 5 6\n", "1\t2\t3\r\n4\t5\t6", "1,2,3\n4, 5, 6\n",
                           "1;2;3\n\n4 ; 5 ; 6\n", "# x y z\n//X Y Z\n1 2 3 # first\n4 5 6\n"}) {
    ExpectEqual(ReadText(text, ReadXyz), expected);
  }
  EXPECT_EQ(ReadText("1,2,3,0.5", ReadXyz).reflectance, std::vector<float>{0.5F});
}

TEST(Xyz, RoundTripsAllDigits) {
  PointCloud cloud = SmallCloud();
  cloud.positions[0] = {0.1, -1.0 / 3.0, 1e-300};
  const std::string written = Written(WriteXyz, cloud);
  ExpectEqual(ReadText(written, ReadXyz), cloud);
  cloud.reflectance = {0.1F, 1.0F / 3.0F, 1e-30F};
  ExpectEqual(ReadText(Written(WriteXyz, cloud), ReadXyz), cloud);
}

TEST(Xyz, RefusesDamagedFiles) {
  EXPECT_THAT(ErrorOfText("# nothing\n", ReadXyz), HasSubstr("file: holds no points"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 2 3.0abc\n", ReadXyz), HasSubstr("file:2: '3.0abc' is not a number"));
  EXPECT_THAT(ErrorOfText("1,0 2,0 3,0\n", ReadXyz), HasSubstr("file:1: found 6 numbers"));
  EXPECT_THAT(ErrorOfText("1,,2,3\n", ReadXyz), HasSubstr("file:1: '' is not a number"));
  EXPECT_THAT(ErrorOfText("1 2 3\n1 2 3 4\n", ReadXyz), HasSubstr("file:2: found 4 numbers where"));
  EXPECT_THAT(ErrorOfText("1 2 NaN\n", ReadXyz), HasSubstr("file:1: the point has a coordinate"));
  EXPECT_THAT(ErrorOfText("1 -inf 3\n", ReadXyz), HasSubstr("file:1: the point has a coordinate"));
}

}  // namespace
}  // namespace ariadne::slam
