#include "slam/io/pcd.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr PcdEncoding kEncodings[] = {PcdEncoding::kAscii, PcdEncoding::kBinary,
                                      PcdEncoding::kBinaryCompressed};

/// A header of lines 1 to 10 for x y z as floats.
std::string Header(int width, int height, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
         "COUNT 1 1 1\nWIDTH " +
         std::to_string(width) + "\nHEIGHT " + std::to_string(height) +
         "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(width * height) + "\nDATA " + data + "\n";
}

std::string Replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

PointCloud ReadPcdCloud(std::istream& in, const std::string& name) { return ReadPcd(in, name).cloud; }

TEST(Pcd, RoundTripsWithTheSameBytes) {
  PointCloud organized = SmallCloudWithAttributes();
  Append(organized, SmallCloudWithAttributes());
  organized.slice_begin = {0, 3};
  for (const PointCloud& cloud : {SmallCloud(), SmallCloudWithAttributes(), organized, PointCloud()}) {
    for (const PcdEncoding encoding : kEncodings) {
      const std::string written = Written(WritePcd, cloud, encoding);
      const CloudFile read = ReadText(written, ReadPcd);
      ExpectEqual(read.cloud, cloud);
      EXPECT_EQ(read.dropped, 0U);
      EXPECT_EQ(Written(WritePcd, read.cloud, encoding), written);
    }
  }
}

TEST(Pcd, CompressesLargeCloudsWell) {
  PointCloud cloud;
  for (int i = 0; i < 50'000; ++i) cloud.positions.emplace_back(i % 7, 2.0, 0.5 * (i % 5));
  const std::string written = Written(WritePcd, cloud, PcdEncoding::kBinaryCompressed);
  EXPECT_LT(written.size(), cloud.size());
  ExpectEqual(ReadText(written, ReadPcdCloud), cloud);
}

TEST(Pcd, ReadsFieldsOfAnyOrderAndType) {
  const std::string header =
      "VERSION .7\nFIELDS rgb z _ x y histogram intensity\nSIZE 4 8 1 2 4 4 1\nTYPE U F U I F F U\n"
      "COUNT 1 1 3 1 1 2 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ";
  PointCloud expected;
  expected.positions = {{-7.0, 1.5, 2.25}};
  expected.reflectance = {200.0F};
  ExpectEqual(ReadText(header + "ascii\n4294967295 2.25 0 0 0 -7 1.5 8 9 200\n", ReadPcdCloud), expected);
  const std::uint8_t pad = 0;
  const std::string record =
      Bytes(std::uint32_t{1}, 2.25, pad, pad, pad, std::int16_t{-7}, 1.5F, 8.0F, 9.0F, std::uint8_t{200});
  ExpectEqual(ReadText(header + "binary\n" + record, ReadPcdCloud), expected);
  // One literal run is the simplest form of LZF; of one point the order of the fields is that of the
  // record.
  const std::string run = std::string(1, static_cast<char>(record.size() - 1)) + record;
  const std::string sizes =
      Bytes(static_cast<std::uint32_t>(run.size()), static_cast<std::uint32_t>(record.size()));
  ExpectEqual(ReadText(header + "binary_compressed\n" + sizes + run, ReadPcdCloud), expected);
}

TEST(Pcd, ReadsIntegersOfEightBytes) {
  const std::string file =
      Replaced(Replaced(Header(1, 1, "binary"), "SIZE 4 4 4", "SIZE 8 8 4"), "TYPE F F F", "TYPE I U F");
  const PointCloud cloud = ReadText(file + Bytes(std::int64_t{-5}, std::uint64_t{6}, 7.0F), ReadPcdCloud);
  EXPECT_EQ(cloud.positions, (std::vector<Eigen::Vector3d>{{-5.0, 6.0, 7.0}}));
}

TEST(Pcd, DropsAndCountsPointsWithoutMeasurement) {
  const CloudFile text = ReadText(Header(3, 1, "ascii") + "1 2 3\nnan nan nan\n4 5 6\n", ReadPcd);
  EXPECT_EQ(text.cloud.positions, (std::vector<Eigen::Vector3d>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(text.dropped, 1U);
  const float nan = std::nanf("");
  const std::string data = Bytes(1.0F, 2.0F, 3.0F, nan, 0.0F, 0.0F, 4.0F, 5.0F, 6.0F);
  const CloudFile binary = ReadText(Header(3, 1, "binary") + data, ReadPcd);
  EXPECT_EQ(binary.cloud.positions, text.cloud.positions);
  EXPECT_EQ(binary.dropped, 1U);
}

TEST(Pcd, TakesSlicesFromTheRows) {
  const std::string rows = "1 0 0\n2 0 0\nnan 0 0\nnan 0 0\n5 0 0\nnan 0 0\n";
  const PointCloud cloud = ReadText(Header(2, 3, "ascii") + rows, ReadPcdCloud);
  EXPECT_EQ(cloud.size(), 3U);
  EXPECT_THAT(cloud.slice_begin, ElementsAre(0, 2, 2));
  EXPECT_FALSE(ReadText(Header(1, 6, "ascii") + rows, ReadPcdCloud).organized());
}

TEST(Pcd, AcceptsWindowsLinesAndPadding) {
  const std::string file = WithWindowsLines(Header(1, 1, "ascii") + "1 2 3\n");
  EXPECT_EQ(ReadText(file, ReadPcdCloud).size(), 1U);
  const std::string padded = Header(1, 1, "binary") + Bytes(1.0F, 2.0F, 3.0F) + std::string(5000, '\0');
  EXPECT_EQ(ReadText(padded, ReadPcdCloud).size(), 1U);
}

TEST(Pcd, RefusesDamagedHeaders) {
  const std::string good = Header(1, 1, "ascii");
  const auto error = [&](const std::string& what, const std::string& by) {
    return ErrorOfText(Replaced(good, what, by) + "1 2 3\n", ReadPcd);
  };
  EXPECT_THAT(ErrorOfText("", ReadPcd), HasSubstr("file:1: the PCD header ends before DATA"));
  EXPECT_THAT(ErrorOfText("ply\n", ReadPcd), HasSubstr("file:1: 'ply' is not a line of a PCD header"));
  EXPECT_THAT(error("VERSION 0.7", "VERSION 0.9"), HasSubstr("file:2: the version is '0.9', expected 0.7"));
  EXPECT_THAT(error("VERSION 0.7\n", ""), HasSubstr("the PCD header has no line VERSION"));
  EXPECT_THAT(error("FIELDS x y z", "FIELDS x y"), HasSubstr("file:5: TYPE has 3 values, expected 2"));
  EXPECT_THAT(error("FIELDS x y z", "FIELDS x y u"), HasSubstr("have no field 'z'"));
  EXPECT_THAT(error("FIELDS x y z", "FIELDS x y X"), HasSubstr("the fields 'x' and 'X' mean the same"));
  EXPECT_THAT(error("SIZE 4 4 4", "SIZE 4 4 3"), HasSubstr("file:5: there is no TYPE 'F' of SIZE 3"));
  EXPECT_THAT(error("SIZE 4 4 4", "SIZE 4 4 x"), HasSubstr("file:4: SIZE cannot be 'x'"));
  EXPECT_THAT(error("TYPE F F F", "TYPE F F D"), HasSubstr("file:5: there is no TYPE 'D' of SIZE 4"));
  EXPECT_THAT(error("COUNT 1 1 1", "COUNT 1 1 0"), HasSubstr("the field 'z' cannot have COUNT 0"));
  EXPECT_THAT(error("COUNT 1 1 1", "COUNT 1 1 99999999999"), HasSubstr("cannot have COUNT 99999999999"));
  EXPECT_THAT(error("COUNT 1 1 1", "COUNT 1 1 2"), HasSubstr("have no field 'z'"));
  EXPECT_THAT(error("WIDTH 1", "WIDTH -1"), HasSubstr("file:7: WIDTH cannot be '-1'"));
  EXPECT_THAT(error("POINTS 1", "POINTS 2"),
              HasSubstr("file:10: POINTS is 2, but WIDTH x HEIGHT is 1 x 1"));
  EXPECT_THAT(error("HEIGHT 1", "HEIGHT 1\nHEIGHT 1"),
              HasSubstr("file:9: HEIGHT stands in the header for the second"));
  EXPECT_THAT(error("VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 2 0 0 0"),
              HasSubstr("file:9: the quaternion"));
  EXPECT_THAT(error("VIEWPOINT 0", "VIEWPOINT nan"), HasSubstr("file:9: 'nan' in VIEWPOINT"));
  EXPECT_THAT(error("VIEWPOINT 0", "VIEWPOINT"), HasSubstr("file:9: VIEWPOINT has 6 values, expected 7"));
  EXPECT_THAT(error("DATA ascii", "DATA zip"), HasSubstr("file:11: DATA is 'zip', expected ascii, binary"));
}

TEST(Pcd, RefusesDamagedText) {
  const auto error = [&](const std::string& data) {
    return ErrorOfText(Header(2, 1, "ascii") + data, ReadPcd);
  };
  EXPECT_THAT(error("10.5 20.5 30.5\n"), HasSubstr("file:13: the file ends after 1 of 2 points"));
  EXPECT_THAT(error("1 2 3\n4.25 5\n"), HasSubstr("file:13: found 2 numbers, expected 3"));
  EXPECT_THAT(error("1 2 3 4\n4 5 6\n"), HasSubstr("file:12: found 4 numbers, expected 3"));
  EXPECT_THAT(error("1 2 3\n4 5 6abc\n"), HasSubstr("file:13: '6abc' is not a number"));
  EXPECT_THAT(error("1 2 3\n4 5 inf\n"),
              HasSubstr("file:13: the point has a coordinate that is NaN or infinite"));
  EXPECT_THAT(error("1 2 3\n4 5 6\n7 8 9\n"),
              HasSubstr("file:14: found '7 8 9' after the end of the data"));
}

TEST(Pcd, RefusesHugeCounts) {
  for (const std::string encoding : {"ascii", "binary", "binary_compressed"}) {
    const std::string header = Replaced(Replaced(Header(1, 1, encoding), "WIDTH 1", "WIDTH 99999999999"),
                                        "POINTS 1", "POINTS 99999999999");
    EXPECT_THAT(ErrorOfText(header + "01234567890123456789", ReadPcd), HasSubstr("99999999999 points"));
  }
  const std::string overflow = Replaced(Replaced(Header(1, 1, "binary"), "WIDTH 1", "WIDTH 4294967296"),
                                        "HEIGHT 1", "HEIGHT 4294967296");
  EXPECT_THAT(ErrorOfText(Replaced(overflow, "POINTS 1", "POINTS 0"), ReadPcd),
              HasSubstr("POINTS is 0, but WIDTH"));
}

TEST(Pcd, RefusesDamagedBinary) {
  const std::string header = Header(2, 1, "binary");
  const std::string first = Bytes(1.0F, 2.0F, 3.0F);
  const std::string size = std::to_string(header.size() + 12);
  EXPECT_THAT(ErrorOfText(header + first + "12345", ReadPcd),
              HasSubstr("file:10: the header announces 2 points, but only 17 bytes follow"));
  EXPECT_THAT(ErrorOfText(header + first + Bytes(1.0F, INFINITY, 3.0F), ReadPcd),
              HasSubstr("file: byte " + size + ": point 2 has a coordinate"));
  EXPECT_THAT(ErrorOfText(header + first + first + "1", ReadPcd), HasSubstr("data follows the last point"));
}

TEST(Pcd, RefusesDamagedCompression) {
  const std::string header = Header(1, 1, "binary_compressed");
  const auto error = [&](const std::string& data) { return ErrorOfText(header + data, ReadPcd); };
  const auto sizes = [](std::uint32_t compressed, std::uint32_t original) {
    return Bytes(compressed, original);
  };
  const std::string run = "\x0b" + Bytes(1.0F, 2.0F, 3.0F);
  EXPECT_EQ(ReadText(header + sizes(13, 12) + run, ReadPcdCloud).size(), 1U);
  EXPECT_THAT(error("123"), HasSubstr("file: byte 178: the file ends before the compressed points"));
  EXPECT_THAT(error(sizes(13, 24) + run),
              HasSubstr("file: byte 179: 24 bytes of points are announced, but 1 points"));
  EXPECT_THAT(error(sizes(14, 12) + run),
              HasSubstr("14 compressed bytes are announced, but only 13 follow"));
  EXPECT_THAT(error(sizes(4000000000, 12) + run), HasSubstr("4000000000 compressed bytes are announced"));
  EXPECT_THAT(error(sizes(0, 12)), HasSubstr("0 compressed bytes cannot hold 12"));
  EXPECT_THAT(error(sizes(12, 12) + run.substr(0, 12)), HasSubstr("the compressed points are damaged"));
  EXPECT_THAT(error(sizes(13, 12) + "\xff" + run.substr(1)),
              HasSubstr("the compressed points are damaged"));
  const std::string many =
      Replaced(Replaced(header, "WIDTH 1", "WIDTH 300000000"), "POINTS 1", "POINTS 300000000");
  EXPECT_THAT(ErrorOfText(many + sizes(13, 3600000000) + run, ReadPcd),
              HasSubstr("13 compressed bytes cannot hold"));
}

}  // namespace
}  // namespace ariadne::slam
