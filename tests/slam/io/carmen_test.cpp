#include "slam/io/carmen.h"

#include <gmock/gmock.h>

#include <numbers>

#include "slam/geometry/angles.h"
#include "slam/io/file.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::string_view kRecord = "FLASER 4 1.5 2 81.91 0.25 1 2 0.5 0.9 2 -4 12.5 host 0.1\n";

std::string CorpusFile(const std::string& name) {
  std::ifstream in(fs::path(ARIADNE_SOURCE_DIR) / "tests/fuzz/corpus/carmen" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ReadCarmen, GivesRangesPosesAndStamp) {
  const std::vector<CarmenSweep> sweeps =
      ReadText("# comment\nODOM 1 2 3\nFLASERS 1\n" + std::string(kRecord), ReadCarmen);
  ASSERT_EQ(sweeps.size(), 1U);
  const CarmenSweep& sweep = sweeps[0];
  EXPECT_EQ(sweep.line, 4U);
  EXPECT_EQ(sweep.sweep.stamp, 12.5);
  ASSERT_EQ(sweep.sweep.ranges.size(), 4U);
  EXPECT_EQ(sweep.sweep.ranges[0], 1.5F);
  EXPECT_TRUE(std::isnan(sweep.sweep.ranges[2]));
  EXPECT_EQ(sweep.T_odom_laser.translation, Eigen::Vector2d(1, 2));
  EXPECT_EQ(sweep.T_odom_laser.angle, 0.5);
  EXPECT_EQ(sweep.T_odom_base.translation, Eigen::Vector2d(0.9, 2));
  EXPECT_NEAR(sweep.T_odom_base.angle, 2.0 * std::numbers::pi - 4.0, 1e-15);
}

TEST(ReadCarmen, SpansTheHalfCircle) {
  const auto step_of = [](int beams) {
    std::string record = fmt::format("FLASER {}", beams);
    for (int i = 0; i < beams; ++i) record += " 1";
    return DegFromRad(ReadText(record + " 0 0 0 0 0 0 0 host 0", ReadCarmen)[0].scanner.angle_step);
  };
  EXPECT_NEAR(step_of(180), 1.0, 1e-12);
  EXPECT_NEAR(step_of(181), 1.0, 1e-12);
  EXPECT_NEAR(step_of(360), 0.5, 1e-12);
  EXPECT_NEAR(step_of(361), 0.5, 1e-12);
}

TEST(ReadCarmen, DecompressesBzip2) {
  const std::string text = CorpusFile("good_text");
  const std::string compressed = CorpusFile("good_compressed");
  ASSERT_LT(0U, compressed.size());
  const auto rewritten = [](const std::string& content) {
    return Written(WriteCarmen, ReadText(content, ReadCarmen));
  };
  EXPECT_EQ(rewritten(compressed), rewritten(text));
  EXPECT_EQ(rewritten(compressed + compressed), rewritten(text + text));
  for (std::size_t size = 3; size < compressed.size(); size += 7) {
    EXPECT_THAT(ErrorOfText(compressed.substr(0, size), ReadCarmen),
                AllOf(StartsWith("file: "), HasSubstr("truncated")));
  }
  std::string damaged = compressed;
  damaged[damaged.size() / 2] ^= 1;
  EXPECT_THAT(ErrorOfText(damaged, ReadCarmen), AllOf(StartsWith("file: "), HasSubstr("damaged")));
}

TEST(ReadCarmen, NamesTheLineOfADamagedRecord) {
  const auto error_of = [](const std::string& record) {
    return ErrorOfText("# log\n" + record + "\n" + std::string(kRecord), ReadCarmen);
  };
  EXPECT_THAT(error_of("FLASER"), AllOf(StartsWith("file:2:"), HasSubstr("number of its ranges")));
  EXPECT_THAT(error_of("FLASER 1 5 0 0 0 0 0 0 1 host 0"), HasSubstr("at least 2"));
  EXPECT_THAT(error_of("FLASER 2 5 0 0 0 0 0 0 1 host 0"), HasSubstr("10 words"));
  EXPECT_THAT(error_of("FLASER 2 5 5 5 0 0 0 0 0 0 1 host 0"), HasSubstr("12 words"));
  EXPECT_THAT(error_of("FLASER 18446744073709551615 5 5 0 0 0 0 0 0 1 host 0"), HasSubstr("words"));
  EXPECT_THAT(error_of("FLASER 2 5 x 0 0 0 0 0 0 1 host 0"), HasSubstr("'x' is not a finite number"));
  EXPECT_THAT(error_of("FLASER 2 5 inf 0 0 0 0 0 0 1 host 0"), HasSubstr("'inf'"));
  EXPECT_THAT(error_of("FLASER 2 5 -0.1 0 0 0 0 0 0 1 host 0"), HasSubstr("below zero"));
  EXPECT_THAT(error_of("FLASER 2 5 5 0 0 nan 0 0 0 1 host 0"), HasSubstr("'nan'"));
  EXPECT_THAT(ErrorOfText("ODOM 0 0 0\n", ReadCarmen), HasSubstr("no FLASER records"));
  EXPECT_THAT(ErrorOfText("", ReadCarmen), HasSubstr("no FLASER records"));
}

TEST(WriteCarmen, KeepsEveryDigit) {
  std::vector<CarmenSweep> sweeps = ReadText(kRecord, ReadCarmen);
  sweeps[0].sweep.ranges[1] = 1.0F / 3.0F;
  sweeps[0].T_odom_base.angle = 1.0 / 3.0;
  const CarmenSweep again = ReadText(Written(WriteCarmen, sweeps), ReadCarmen).at(0);
  EXPECT_EQ(again.sweep.ranges[1], 1.0F / 3.0F);
  EXPECT_EQ(again.T_odom_base.angle, 1.0 / 3.0);
  sweeps[0].scanner.angle_step *= 0.5;
  EXPECT_THAT(ErrorOf([&] { Written(WriteCarmen, sweeps); }), HasSubstr("180 deg"));
}

TEST(ReadCarmen, ReadsTheLogOfABuilding) {
  const fs::path log = DataFolder() / "sweeps2d/fr079.clf.bz2";
  ARIADNE_REQUIRE_DATA(log);
  std::ifstream in = OpenForReading(log);
  CarmenReader reader(in, log.string());
  std::size_t sweeps = 0;
  double last_range = 0.0;
  while (const std::optional<CarmenSweep> sweep = reader.Next()) {
    ++sweeps;
    ASSERT_EQ(sweep->sweep.ranges.size(), 360U);
    last_range = sweep->sweep.ranges.back();
    const Pose2 T_base_laser = sweep->T_odom_base.Inverse() * sweep->T_odom_laser;
    ASSERT_NEAR(T_base_laser.translation.x(), -0.04, 1e-4);  // PARAM robot_frontlaser_offset
  }
  EXPECT_EQ(sweeps, 4934U);
  EXPECT_GT(last_range, 0.0);
}

}  // namespace
}  // namespace ariadne::slam
