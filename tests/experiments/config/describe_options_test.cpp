// The manual: of a small struct word by word, and of every experiment as a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "experiments/studies/catalog.h"
#include "tests/experiments/config/garden_options.h"

namespace ariadne::experiments {
namespace {

using testing::ElementsAre;

std::vector<std::string> Fields(const OptionDescription& option) {
  return {option.key, option.value, option.unit, option.range, option.reason};
}

TEST(DescribeOptions, TellsKeyDefaultUnitRangeAndReason) {
  const std::vector<OptionDescription> manual = DescribeOptions<GardenOptions>();
  ASSERT_EQ(manual.size(), 8U);
  EXPECT_THAT(Fields(manual[0]), ElementsAre("owner", "Ada", "", "text", "who picks"));
  EXPECT_THAT(Fields(manual[1]),
              ElementsAre("watering", "weekly", "", "never, weekly, daily", "how often"));
  EXPECT_THAT(Fields(manual[2]), ElementsAre("fenced", "true", "", "true, false", "against hares"));
  EXPECT_THAT(Fields(manual[3]), ElementsAre("height", "0.1", "m", "0 to 1000000", "of the fence"));
  EXPECT_THAT(Fields(manual[6]),
              ElementsAre("cold_frame.width", "0.75", "m", "0.1 to 10", "an arm reaches half of it"));
  EXPECT_THAT(Fields(manual[7]),
              ElementsAre("cold_frame.plants", "12", "", "-1 to 100", "-1: as many as fit"));
}

class DescribeStudy : public testing::TestWithParam<std::string> {
 protected:
  const Study& study() const { return FindStudy(GetParam()); }
  /// The entries of the config with all defaults.
  OptionEntries Defaults() const {
    OptionEntries entries = OptionEntries::FromText(study().defaults(), "defaults");
    entries.Take("experiment");
    return entries;
  }
};
std::vector<std::string> NamesOfStudies() {
  std::vector<std::string> names;
  for (const Study& study : AllStudies()) names.push_back(study.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Studies, DescribeStudy, testing::ValuesIn(NamesOfStudies()),
                         [](const auto& name) { return name.param; });

TEST_P(DescribeStudy, LeavesNothingEmpty) {
  for (const OptionDescription& option : study().describe()) {
    EXPECT_NE(option.range, "") << option.key;
    EXPECT_GT(option.reason.size(), 7U) << option.key << " needs the paper's section or the reason";
    if (option.range != "text") {
      EXPECT_NE(option.value, "") << option.key;
    }
  }
}

TEST_P(DescribeStudy, TellsTheUnitOfEveryLength) {
  for (const OptionDescription& option : study().describe()) {
    const std::string name = "_" + option.key.substr(option.key.rfind('.') + 1);
    for (const char* length :
         {"_distance", "_range", "_radius", "_translation", "_voxel_size", "_height"}) {
      const bool number = option.range.find(" to ") != std::string::npos;
      if (!number || !name.ends_with(length)) continue;
      EXPECT_EQ(option.unit, "m") << option.key;
    }
  }
}

TEST_P(DescribeStudy, TellsEveryKeyOnceAndItsTrueDefault) {
  const OptionEntries defaults = Defaults();
  const std::vector<OptionDescription> manual = study().describe();
  ASSERT_EQ(defaults.entries().size(), manual.size());
  std::set<std::string> keys;
  for (std::size_t i = 0; i < manual.size(); ++i) {
    EXPECT_EQ(defaults.entries()[i].key, manual[i].key) << "in the order of the config";
    EXPECT_EQ(defaults.entries()[i].value, manual[i].value) << manual[i].key;
    EXPECT_TRUE(keys.insert(manual[i].key).second) << manual[i].key;
  }
}

TEST_P(DescribeStudy, GivesDefaultsThatItTakes) {
  EXPECT_EQ(study().resolve(Defaults()), study().defaults());
}

}  // namespace
}  // namespace ariadne::experiments
