#include "slam/io/ply.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

template <typename T>
T Swapped(T number) {
  std::string bytes = Bytes(number);
  std::reverse(bytes.begin(), bytes.end());
  std::memcpy(&number, bytes.data(), sizeof(T));
  return number;
}

std::string Header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\n" + elements + "end_header\n";
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

TEST(Ply, RoundTripsWithTheSameBytes) {
  for (const PointCloud& cloud : {SmallCloud(), SmallCloudWithAttributes(), PointCloud()}) {
    for (const PlyEncoding encoding : {PlyEncoding::kAscii, PlyEncoding::kBinary}) {
      const std::string written = Written(WritePly, cloud, encoding);
      const PointCloud read = ReadText(written, ReadPly);
      ExpectEqual(read, cloud);
      EXPECT_EQ(Written(WritePly, read, encoding), written);
    }
  }
}

TEST(Ply, ReadsPropertiesOfAnyOrderAndType) {
  const std::string header =
      Header("ascii",
             "element vertex 2\nproperty uchar red\nproperty double z\nproperty int x\n"
             "property short y\nproperty uchar scalar_Intensity\n");
  const PointCloud cloud = ReadText(header + "255 3.5 1 2 7\n0 -6 4 5 8\n", ReadPly);
  EXPECT_EQ(cloud.positions, (std::vector<Eigen::Vector3d>{{1, 2, 3.5}, {4, 5, -6}}));
  EXPECT_EQ(cloud.reflectance, (std::vector<float>{7, 8}));
}

TEST(Ply, ReadsBinaryOfBothByteOrders) {
  const std::string elements =
      "element vertex 1\nproperty uchar red\nproperty double y\nproperty short z\n"
      "property float x\nproperty uint reflectance\n";
  const std::string little = Bytes(std::uint8_t{9}, 2.5, std::int16_t{-3}, 1.5F, std::uint32_t{70000});
  const std::string big = Bytes(std::uint8_t{9}, Swapped(2.5), Swapped(std::int16_t{-3}), Swapped(1.5F),
                                Swapped(std::uint32_t{70000}));
  for (const std::string& file :
       {Header("binary_little_endian", elements) + little, Header("binary_big_endian", elements) + big}) {
    const PointCloud cloud = ReadText(file, ReadPly);
    EXPECT_EQ(cloud.positions, (std::vector<Eigen::Vector3d>{{1.5, 2.5, -3.0}}));
    EXPECT_EQ(cloud.reflectance, std::vector<float>{70000.0F});
  }
}

TEST(Ply, SkipsOtherElementsAndLists) {
  const std::string elements =
      "element camera 1\nproperty float f\nproperty list uchar short ids\n"
      "element vertex 2\nproperty list uchar int neighbours\n" +
      kXyz + "element face 1\nproperty list uchar int vertex_indices\n";
  const PointCloud text =
      ReadText(Header("ascii", elements) + "0.5 2 7 8\n1 5 1 2 3\n0 4 5 6\n3 0 1 0\n", ReadPly);
  EXPECT_EQ(text.positions, (std::vector<Eigen::Vector3d>{{1, 2, 3}, {4, 5, 6}}));
  const std::string data = Bytes(0.5F, std::uint8_t{2}, std::int16_t{7}, std::int16_t{8}) +
                           Bytes(std::uint8_t{1}, 5, 1.0F, 2.0F, 3.0F) +
                           Bytes(std::uint8_t{0}, 4.0F, 5.0F, 6.0F) + Bytes(std::uint8_t{3}, 0, 1, 0);
  EXPECT_EQ(ReadText(Header("binary_little_endian", elements) + data, ReadPly).positions, text.positions);
}

TEST(Ply, AcceptsWindowsLines) {
  const std::string file = WithWindowsLines(Header("ascii", "element vertex 1\n" + kXyz) + "1 2 3\n");
  EXPECT_EQ(ReadText(file, ReadPly).size(), 1U);
}

TEST(Ply, ScalesNormalsToUnitLength) {
  const std::string header = Header(
      "ascii", "element vertex 1\n" + kXyz + "property float nx\nproperty float ny\nproperty float nz\n");
  const PointCloud cloud = ReadText(header + "1 2 3 0 3 4\n", ReadPly);
  EXPECT_TRUE(cloud.normals[0].isApprox(Eigen::Vector3d(0.0, 0.6, 0.8), 1e-15));
  EXPECT_THAT(ErrorOfText(header + "1 2 3 0 0 0\n", ReadPly),
              HasSubstr("has a normal that is zero, NaN or infinite"));
}

TEST(PlyWriter, WritesAMapOfSeveralScans) {
  std::ostringstream out;
  PlyWriter writer(out, PlyEncoding::kAscii, {.reflectance = true, .colors = true, .scan_index = true}, 6);
  const std::vector<PlyWriter::Rgb> one_color{{255, 0, 10}};
  const std::vector<PlyWriter::Rgb> colors{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  writer.Add(SmallCloudWithAttributes(), {one_color, 0});
  EXPECT_THAT(ErrorOf([&] { writer.Finish(); }), HasSubstr("3 points where the PLY header announces 6"));
  writer.Add(SmallCloudWithAttributes(), {colors, 12});
  writer.Finish();
  EXPECT_THAT(out.str(),
              HasSubstr("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                        "property float scalar_reflectance\nproperty int scalar_scan_index\nend_header\n"
                        "1 2 3 255 0 10 0.5 0\n"));
  EXPECT_THAT(out.str(), HasSubstr("\n-0.5 0.25 8 4 5 6 17 12\n"));
  EXPECT_EQ(ReadText(out.str(), ReadPly).size(), 6U);
}

TEST(PlyWriter, RefusesWhatTheHeaderDoesNotSay) {
  std::ostringstream out;
  PlyWriter writer(out, PlyEncoding::kBinary, {.reflectance = true}, 2);
  EXPECT_THAT(ErrorOf([&] { writer.Add(SmallCloud()); }), HasSubstr("lacks an attribute"));
  EXPECT_THAT(ErrorOf([&] { writer.Add(SmallCloudWithAttributes()); }),
              HasSubstr("more points than the 2"));
}

TEST(Ply, RefusesDamagedHeaders) {
  const auto error = [](const std::string& text) { return ErrorOfText(text, ReadPly); };
  EXPECT_THAT(error(""), HasSubstr("file:1: is not a PLY file"));
  EXPECT_THAT(error("pcd\n"), HasSubstr("file:1: is not a PLY file"));
  EXPECT_THAT(error("ply\nformat ascii 1.0\n"), HasSubstr("file:3: the file ends before 'end_header'"));
  EXPECT_THAT(error("ply\nformat latin 1.0\n"), HasSubstr("file:2: expected 'format ascii 1.0'"));
  EXPECT_THAT(error("ply\nend_header\n"), HasSubstr("file:2: the header has no line 'format"));
  EXPECT_THAT(error("ply\nproperty float x\n"),
              HasSubstr("'property float x' is not a line of a PLY header"));
  EXPECT_THAT(error(Header("ascii", "element vertex -1\n" + kXyz)),
              HasSubstr("file:4: '-1' is not a number of"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\nproperty half x\n")),
              HasSubstr("file:5: 'half' is not a type"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\nproperty x\n")),
              HasSubstr("file:5: expected 'property"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\nproperty list float int a\n")),
              HasSubstr("file:5: the length of a list must be an integer"));
  EXPECT_THAT(error(Header("ascii", "")), HasSubstr("must announce the element 'vertex' once"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\n" + kXyz + "property int X\n") + "1 2 3 4\n"),
              HasSubstr("the fields 'x' and 'X' mean the same"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "1 2\n"),
              HasSubstr("have no field 'z'"));
  EXPECT_THAT(error(Header("ascii", "element vertex 1\n" + kXyz + "element tag 2\n") + "1 2 3\n"),
              HasSubstr("file:8: the element 'tag' has no properties"));
}

TEST(Ply, RefusesDamagedText) {
  const std::string header = Header("ascii", "element vertex 2\n" + kXyz);
  const auto error = [&](const std::string& data) { return ErrorOfText(header + data, ReadPly); };
  EXPECT_THAT(error("1 2 3\n"),
              HasSubstr("file:4: the header announces 2 times 'vertex', but only 6 bytes follow"));
  EXPECT_THAT(error("10.5 20.5 30.5\n"), HasSubstr("file:9: the file ends in 'vertex' 2 of 2"));
  EXPECT_THAT(error("1 2 3\n4 5\n7 8 9\n"),
              HasSubstr("file:10: the line has too few numbers in 'vertex' 2 of 2"));
  EXPECT_THAT(error("1 2 3 4\n4 5 6\n"),
              HasSubstr("file:9: the line has too many numbers in 'vertex' 1 of 2"));
  EXPECT_THAT(error("1 2 3\n4 5 6x\n"), HasSubstr("file:10: '6x' is not a number"));
  EXPECT_THAT(error("1 2 3\n4 5 nan\n"), HasSubstr("file:10: the vertex has a coordinate that is NaN"));
  EXPECT_THAT(error("1 2 3\n4 5 6\n7 8 9\n"),
              HasSubstr("file:11: found '7 8 9' after the end of the data"));
}

TEST(Ply, RefusesHugeCounts) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    EXPECT_THAT(
        ErrorOfText(Header(format, "element vertex 4000000000\n" + kXyz) + "1 2 3\n", ReadPly),
        HasSubstr("file:4: the header announces 4000000000 times 'vertex', but only 6 bytes follow"));
    EXPECT_THAT(ErrorOfText(Header(format, "element vertex 18446744073709551615\n" + kXyz), ReadPly),
                HasSubstr("but only 0 bytes follow"));
  }
}

TEST(Ply, RefusesDamagedBinary) {
  const std::string header = Header("binary_little_endian", "element vertex 2\n" + kXyz);
  const std::string size = std::to_string(header.size() + 12);
  const std::string first = Bytes(1.0F, 2.0F, 3.0F);
  EXPECT_THAT(ErrorOfText(header + first, ReadPly), HasSubstr("file:4: the header announces 2 times"));
  EXPECT_THAT(ErrorOfText(header + first + Bytes(1.0F, 2.0F, std::nanf("")), ReadPly),
              HasSubstr("file: byte " + size + ": point 2 has a coordinate that is NaN"));
  EXPECT_EQ(ReadText(header + first + first + std::string(100, '\0'), ReadPly).size(), 2U);  // padding
  EXPECT_THAT(ErrorOfText(header + first + first + "x", ReadPly), HasSubstr("data follows the last point"));
}

TEST(Ply, RefusesDamagedLists) {
  const std::string elements =
      "element vertex 1\n" + kXyz + "element face 1\nproperty list int int vertex_indices\n";
  const std::string text = Header("ascii", elements) + "1 2 3\n";
  EXPECT_THAT(ErrorOfText(text + "3 0 1\n", ReadPly),
              HasSubstr("file:12: a list is longer than its line in 'face' 1"));
  EXPECT_THAT(ErrorOfText(text + "-1\n", ReadPly), HasSubstr("the length of a list is not a count"));
  EXPECT_THAT(ErrorOfText(text + "0.5\n", ReadPly), HasSubstr("the length of a list is not a count"));
  const std::string binary = Header("binary_little_endian", elements) + Bytes(1.0F, 2.0F, 3.0F);
  EXPECT_THAT(ErrorOfText(binary + Bytes(3, 0, 1), ReadPly),
              HasSubstr("a list runs over the end of the file in 'face' 1"));
  EXPECT_THAT(ErrorOfText(binary + Bytes(2000000000), ReadPly),
              HasSubstr("a list runs over the end of the file"));
  EXPECT_THAT(ErrorOfText(binary + Bytes(-1), ReadPly), HasSubstr("the length of a list is not a count"));
}

}  // namespace
}  // namespace ariadne::slam
