#include "experiments/render/png_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::filesystem::path TemporaryFile(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("ariadne_png_file_test_" + name);
}

std::string BytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Image Gradient() {
  Image image(37, 23);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x)
      image.At(x, y) = {ToChannel(7 * x), ToChannel(11 * y), ToChannel(x * y)};
  }
  return image;
}

TEST(PngFile, RoundTrips) {
  const auto path = TemporaryFile("round_trip.png");
  WritePng(path, Gradient());
  EXPECT_EQ(ReadPng(path), Gradient());
}

TEST(PngFile, SamePictureGivesSameBytes) {
  const auto first = TemporaryFile("first.png");
  const auto second = TemporaryFile("second.png");
  WritePng(first, Gradient());
  WritePng(second, Gradient());
  EXPECT_EQ(BytesOf(first), BytesOf(second));
  EXPECT_THAT(BytesOf(first), testing::Not(HasSubstr("tIME")));
}

TEST(PngFile, NamesTheFileThatCannotBeWritten) {
  EXPECT_THAT([] { WritePng("/no/such/folder/a.png", Gradient()); },
              ThrowsMessage<Error>(AllOf(HasSubstr("/no/such/folder/a.png"), HasSubstr("No such file"))));
}

TEST(PngFile, ReportsAFullDiskAndLeavesTheDeviceAlone) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  EXPECT_THAT([] { WritePng("/dev/full", Gradient()); },
              ThrowsMessage<Error>(AllOf(HasSubstr("/dev/full"), HasSubstr("No space left"))));
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST(PngFile, RefusesAnEmptyPicture) {
  EXPECT_THAT([] { WritePng(TemporaryFile("empty.png"), Image()); },
              ThrowsMessage<Error>(HasSubstr("no pixels")));
}

TEST(PngFile, RefusesDamagedFiles) {
  const auto path = TemporaryFile("damaged.png");
  WritePng(path, Gradient());
  const std::string bytes = BytesOf(path);
  std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  EXPECT_THAT([&] { ReadPng(path); }, ThrowsMessage<Error>(HasSubstr(path.string())));
  std::ofstream(path, std::ios::binary) << "not a picture";
  EXPECT_THROW(ReadPng(path), Error);
  EXPECT_THROW(ReadPng(TemporaryFile("missing.png")), Error);
}

}  // namespace
}  // namespace ariadne::experiments
