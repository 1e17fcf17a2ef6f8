#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/config/options_io.h"
#include "tests/experiments/config/garden_options.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

GardenOptions Read(const std::string& text, const std::vector<std::string>& assignments = {}) {
  OptionEntries entries = OptionEntries::FromText(text, "garden.yaml");
  for (const std::string& assignment : assignments) entries.Set(assignment);
  return ReadOptions<GardenOptions>(entries);
}

std::string ErrorOfText(const std::string& text) {
  return ErrorOf([&] { Read(text); });
}

TEST(ReadOptions, TakesValuesOfEveryType) {
  const GardenOptions options = Read(
      "owner: Grace\nwatering: daily\nfenced: false\nheight: 1.5e-3\nbed:\n  plants: -1\n  width: 2\n");
  EXPECT_EQ(options.owner, "Grace");
  EXPECT_EQ(options.watering, Watering::kDaily);
  EXPECT_FALSE(options.fenced);
  EXPECT_EQ(options.height, 0.0015);
  EXPECT_EQ(options.bed.plants, -1);
  EXPECT_EQ(options.bed.width, 2.0);
}

TEST(ReadOptions, LeavesTheDefaultsOfWhatIsNotWritten) {
  const GardenOptions options = Read("cold_frame:\n  plants: 3\n");
  EXPECT_EQ(options.cold_frame.plants, 3);
  EXPECT_EQ(options.cold_frame.width, 0.75) << "the default of the member, not of its type";
  EXPECT_EQ(options.bed.plants, 12);
  EXPECT_EQ(options.owner, "Ada");
}

TEST(ReadOptions, LetsTheLastAssignmentWin) {
  EXPECT_EQ(Read("bed:\n  plants: 3\n").bed.plants, 3);
  EXPECT_EQ(Read("bed:\n  plants: 3\n", {"bed.plants=4"}).bed.plants, 4);
  EXPECT_EQ(Read("bed:\n  plants: 3\n", {"bed.plants=4", "bed.plants=5"}).bed.plants, 5);
  EXPECT_EQ(Read("", {"owner="}).owner, "");
}

TEST(ReadOptions, NamesTheNearestKeyForAnUnknownOne) {
  const auto error = [](const std::string& line) { return ErrorOfText("owner: Ada\n" + line); };
  EXPECT_EQ(error("ownr: Ada\n"), "garden.yaml:2: unknown key ownr; did you mean owner?");
  EXPECT_EQ(error("bed:\n  plnats: 3\n"),
            "garden.yaml:3: unknown key bed.plnats; did you mean bed.plants?");
  EXPECT_EQ(error("bed.widht: 3\n"), "garden.yaml:2: unknown key bed.widht; did you mean bed.width?");
  EXPECT_THAT(error("widht: 3\n"), EndsWith("did you mean bed.width?")) << "not height";
  EXPECT_THAT(error("plants: 3\n"), EndsWith("did you mean bed.plants?")) << "without its section";
  EXPECT_THAT(error("cold_frame:\n  plant: 3\n"), EndsWith("did you mean cold_frame.plants?"));
  EXPECT_THAT(error("bed: 3\n"), HasSubstr("garden.yaml:2: unknown key bed")) << "a section has no value";
  EXPECT_THAT(error("owner_: Ada\n"), EndsWith("did you mean owner?"));
}

TEST(ReadOptions, NamesTheAssignmentThatIsWrong) {
  const auto error = [](const std::string& assignment) {
    return ErrorOf([&] { Read("owner: Ada\n", {assignment}); });
  };
  EXPECT_EQ(error("ownr=Ada"), "--set ownr=Ada: unknown key ownr; did you mean owner?");
  EXPECT_EQ(error("height=-1"), "--set height=-1: height must be in 0 to 1000000 m, not -1");
  EXPECT_EQ(error("fenced=yes"), "--set fenced=yes: fenced must be true or false, not 'yes'");
}

TEST(ReadOptions, RefusesAWrongType) {
  EXPECT_EQ(ErrorOfText("height: high\n"), "garden.yaml:1: height must be a number, not 'high'");
  EXPECT_EQ(ErrorOfText("watering: hourly\n"),
            "garden.yaml:1: watering must be one of never, weekly, daily, not 'hourly'");
  EXPECT_EQ(ErrorOfText("\nfenced: 1\n"), "garden.yaml:2: fenced must be true or false, not '1'");
  for (const char* text : {"1 m", "1,5", "0x10", "''", "1.5.2"}) {
    EXPECT_THAT(ErrorOfText(std::string("height: ") + text + "\n"), HasSubstr("must be a number")) << text;
  }
  for (const char* text : {"2.5", "1e1", "twelve", "99999999999999999999"}) {
    EXPECT_THAT(ErrorOfText(std::string("bed:\n  plants: ") + text + "\n"),
                HasSubstr("garden.yaml:2: bed.plants must be a whole number"))
        << text;
  }
}

TEST(ReadOptions, RefusesNumbersThatAreNone) {
  for (const char* text : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_THAT(ErrorOfText(std::string("height: ") + text + "\n"),
                testing::ContainsRegex("garden.yaml:1: height must be a (finite )?number"))
        << text;
  }
}

TEST(ReadOptions, TakesBothEndsOfARangeAndNothingBeyond) {
  EXPECT_EQ(Read("bed:\n  width: 0.1\n").bed.width, 0.1);
  EXPECT_EQ(Read("bed:\n  width: 10\n").bed.width, 10.0);
  EXPECT_EQ(Read("bed:\n  plants: 100\n").bed.plants, 100);
  EXPECT_EQ(ErrorOfText("bed:\n  width: 10.0001\n"),
            "garden.yaml:2: bed.width must be in 0.1 to 10 m, not 10.0001");
  EXPECT_EQ(ErrorOfText("bed:\n  width: 0.0999\n"),
            "garden.yaml:2: bed.width must be in 0.1 to 10 m, not 0.0999");
  EXPECT_EQ(ErrorOfText("bed:\n  plants: 101\n"),
            "garden.yaml:2: bed.plants must be in -1 to 100, not 101");
  EXPECT_EQ(ErrorOfText("bed:\n  plants: -2\n"), "garden.yaml:2: bed.plants must be in -1 to 100, not -2");
}

TEST(ReadOptions, DoesNotLetAHugeIntegerWrapIntoTheRange) {
  EXPECT_THAT(ErrorOfText("bed:\n  plants: 4294967298\n"), HasSubstr("must be in -1 to 100"));
}

}  // namespace
}  // namespace ariadne::experiments
