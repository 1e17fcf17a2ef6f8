// Every config in experiments/configs can be read, and survives being resolved.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "experiments/studies/catalog.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> ShippedConfigs() {
  std::vector<fs::path> configs;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(ARIADNE_SOURCE_DIR "/experiments/configs")) {
    configs.push_back(entry.path());
  }
  std::ranges::sort(configs);
  return configs;
}

/// The options of a config without the key that names its experiment.
struct Config {
  std::string experiment;
  OptionEntries entries;
};

Config Split(OptionEntries entries) {
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  return {experiment ? experiment->value : "", entries};
}

class ShippedConfig : public testing::TestWithParam<fs::path> {
 protected:
  Config Read() const { return Split(OptionEntries::FromFile(GetParam().string())); }
};
INSTANTIATE_TEST_SUITE_P(Configs, ShippedConfig, testing::ValuesIn(ShippedConfigs()),
                         [](const auto& path) { return path.param.stem().string(); });

TEST(ShippedConfigs, AreThere) {
  EXPECT_GE(ShippedConfigs().size(), 12U);
  for (const fs::path& path : ShippedConfigs()) EXPECT_EQ(path.extension(), ".yaml") << path;
}

TEST_P(ShippedConfig, Loads) {
  const Config config = Read();
  ASSERT_NE(config.experiment, "") << "it must say what to run";
  EXPECT_NO_THROW(FindStudy(config.experiment).resolve(config.entries));
}

TEST_P(ShippedConfig, ResolvesToTheSameTextAgain) {
  const Config config = Read();
  const std::string resolved = FindStudy(config.experiment).resolve(config.entries);
  const Config again = Split(OptionEntries::FromText(resolved, "config.yaml"));
  EXPECT_EQ(again.experiment, config.experiment);
  EXPECT_EQ(FindStudy(again.experiment).resolve(again.entries), resolved);
}

TEST_P(ShippedConfig, HoldsOnlyWhatDiffersFromTheDefaults) {
  const Config config = Read();
  const OptionEntries defaults =
      Split(OptionEntries::FromText(FindStudy(config.experiment).defaults(), "defaults")).entries;
  for (const OptionEntry& entry : config.entries.entries()) {
    // Which scans, and by which method, may be said for clarity.
    if (entry.key.starts_with("input.") || entry.key == "registration.method") continue;
    OptionEntries rest = defaults;
    EXPECT_NE(rest.Take(entry.key)->value, entry.value) << entry.where << ": " << entry.key;
  }
}

TEST(FindStudy, NamesThoseThatThereAre) {
  EXPECT_EQ(
      ErrorOf([] { FindStudy("table_2"); }),
      "there is no experiment 'table_2'; there are register, explore, optimize, posegraph_benchmark, "
      "extract, map, plan, simulate, table_1, fig_01, fig_02, fig_03, fig_04, fig_05, fig_06, fig_07, "
      "fig_08, fig_09, fig_10, fig_11, fig_12, fig_13, ablation_matching, ablation_features, "
      "ablation_graph, ablation_nbv, ablation_mission, walking_persons, "
      "ablation_control, planning_time");
  EXPECT_THAT(ErrorOf([] { FindStudy("", "my.yaml:1"); }), testing::StartsWith("my.yaml:1: there is no"));
}

}  // namespace
}  // namespace ariadne::experiments
