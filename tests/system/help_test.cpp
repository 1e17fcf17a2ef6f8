#include <gmock/gmock.h>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Help : public ProgramTest, public testing::WithParamInterface<std::string> {};
INSTANTIATE_TEST_SUITE_P(Commands, Help,
                         testing::Values("explore", "register", "optimize", "run", "emulate", "convert",
                                         "info", "config", "simulate", "extract", "map", "export", "view",
                                         "devices", "log", "replay", "calibrate", "check"),
                         [](const auto& name) { return name.param; });

TEST_P(Help, EndsWithAnExample) {
  const Ended ended = Ariadne(GetParam() + " --help");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, HasSubstr("Example:\n  ariadne " + GetParam() + " "));
}

TEST_P(Help, OfTheProgramNamesTheCommand) {
  EXPECT_THAT(Must("--help"),
              AllOf(HasSubstr("\n  " + GetParam() + " "), HasSubstr("Example:\n  ariadne ")));
}

TEST_P(Help, IsShortInTheShell) {
  std::istringstream text(Must(GetParam() + " --help"));
  for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 120U) << line;
}

using ConfigCommand = ProgramTest;

TEST_F(ConfigCommand, PrintsAConfigThatTheProgramTakes) {
  folder_.Write("my.yaml", Must("config register"));
  Must("register --config my.yaml --out run" + kSmall);
  EXPECT_THAT(Content("run/config.yaml"), HasSubstr("    beams: 61\n"));
}

TEST_F(ConfigCommand, PrintsTheManual) {
  const std::string manual = Must("config --describe");
  EXPECT_THAT(
      manual,
      HasSubstr("\nregistration.overlap_pairs = 250 pairs\n    0 to 1000000000\n    two scans overlap if"));
  EXPECT_THAT(manual, HasSubstr("\nicp.metric = plane_to_plane\n    point_to_point, point_to_plane, "));
  EXPECT_THAT(manual, HasSubstr("\ninput.poses = ''\n    text\n"));
}

TEST_F(ConfigCommand, PrintsThatOfEachExperiment) {
  EXPECT_THAT(Must("config table_1"), testing::StartsWith("experiment: table_1\n"));
  EXPECT_THAT(Must("config table_1 --describe"), HasSubstr("\nrepeats = 5\n"));
  const Ended unknown = Ariadne("config table_2");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err,
              testing::StartsWith(
                  "ariadne: there is no experiment 'table_2'; there are register, "
                  "explore, optimize, posegraph_benchmark, extract, map, plan, simulate, table_1, "));
}

}  // namespace
}  // namespace ariadne
