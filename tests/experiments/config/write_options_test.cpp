#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "experiments/config/options_io.h"
#include "tests/experiments/config/garden_options.h"

namespace ariadne::experiments {
namespace {

GardenOptions ReadBack(const std::string& text) {
  return ReadOptions<GardenOptions>(OptionEntries::FromText(text, "written.yaml"));
}

TEST(WriteOptions, WritesEveryOptionInItsSection) {
  EXPECT_EQ(WriteOptions(GardenOptions()),
            "owner: Ada\nwatering: weekly\nfenced: true\nheight: 0.1\n"
            "bed:\n  width: 1.25\n  plants: 12\n"
            "cold_frame:\n  width: 0.75\n  plants: 12\n");
}

TEST(WriteOptions, ReadsBackToTheSameOptions) {
  GardenOptions options;
  options.watering = Watering::kNever;
  options.fenced = false;
  options.height = 1.0 / 3.0;
  options.bed = {.width = 0.1 + 0.2, .plants = -1};
  const GardenOptions read = ReadBack(WriteOptions(options));
  EXPECT_EQ(read.watering, options.watering);
  EXPECT_EQ(read.fenced, options.fenced);
  EXPECT_EQ(read.height, options.height) << "to the last bit";
  EXPECT_EQ(read.bed.width, options.bed.width);
  EXPECT_EQ(read.bed.plants, options.bed.plants);
  EXPECT_EQ(WriteOptions(read), WriteOptions(options));
}

TEST(WriteOptions, KeepsEveryBitOfANumber) {
  for (const double height : {0.0, 1e-300, std::numeric_limits<double>::denorm_min(), 1e6,
                              999999.9999999999, 0.1, 123456.789012345678}) {
    GardenOptions options;
    options.height = height;
    EXPECT_EQ(ReadBack(WriteOptions(options)).height, height);
  }
}

class WriteText : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Texts, WriteText,
                         testing::Values("", " ", "two words", " leading", "trailing ", "a: b", "a:b", "#x",
                                         "a #b", "- a", "-", "---", "...", "?", "? a", "~", "null", "Null",
                                         "NULL", "true", "1e3", "it's", "''", "\"quoted\"", "[a]", "{a}",
                                         "a, b", "&a", "*a", "!a", "|", ">", "%a", "@a", "`a`", "C:\\scans",
                                         "=", "<<", "a\nb", "\n", "a\r\nb", "tab\there", "\x01", "\x7f",
                                         "Gänge/größer", "$ARIADNE_DATA/scans", "builtin:office"));

TEST_P(WriteText, ReadsBackToTheSameText) {
  GardenOptions options;
  options.owner = GetParam();
  const std::string text = WriteOptions(options);
  const GardenOptions read = ReadBack(text);
  EXPECT_EQ(read.owner, GetParam()) << text;
  EXPECT_EQ(read.height, 0.1) << "what follows is not disturbed";
  EXPECT_EQ(WriteOptions(read), text);
}

}  // namespace
}  // namespace ariadne::experiments
