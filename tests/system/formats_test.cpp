// convert, info, and the files of a run as others read them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

struct Form {
  std::string extension;
  std::string encoding;  // empty: the format's own
  std::string Flag() const { return encoding.empty() ? "" : " --encoding " + encoding; }
};

const std::vector<Form> kForms{{"3d", ""},
                               {"xyz", ""},
                               {"ply", "ascii"},
                               {"ply", "binary"},
                               {"pcd", "ascii"},
                               {"pcd", "binary"},
                               {"pcd", "binary_compressed"},
                               {"bin", ""}};

class Convert : public ProgramTest, public testing::WithParamInterface<Form> {};
INSTANTIATE_TEST_SUITE_P(From, Convert, testing::ValuesIn(kForms), [](const auto& form) {
  return form.param.extension + (form.param.encoding.empty() ? "" : "_" + form.param.encoding);
});

TEST_P(Convert, ToEveryFormatAndBackKeepsEveryPoint) {
  // Exact as floats, in metres and in centimetres.
  const std::string points = "1.5 2.25 -3.125 0.5\n-0.75 8.5 100.25 17\n63.5 -12.125 0.5 255\n";
  folder_.Write("start.xyz", points);
  const std::string from = "from." + GetParam().extension;
  Must("convert start.xyz " + from + GetParam().Flag());
  for (const Form& to : kForms) {
    const std::string between = "to." + to.extension;
    Must("convert " + from + " " + between + to.Flag());
    Must("convert " + between + " end.xyz");
    EXPECT_EQ(Content("end.xyz"), points) << to.extension << to.Flag();
  }
}

using ConvertCommand = ProgramTest;

TEST_F(ConvertCommand, SaysWhatItHasWritten) {
  folder_.Write("a.xyz", "1 2 3 4\n5 6 7 8\n");
  EXPECT_EQ(Must("convert a.xyz a.ply"), "a.ply: 2 points, with reflectance\n");
  folder_.Write("scan.dat", "100 200 300\n");
  EXPECT_EQ(Must("convert scan.dat b.xyz --format uos"), "b.xyz: 1 points\n");
  EXPECT_EQ(Content("b.xyz"), "3 -1 2\n") << "centimetres, left-handed";
}

TEST_F(ConvertCommand, LeavesTheOldFileWhereItFails) {
  folder_.Write("a.ply", "old");
  folder_.Write("bad.xyz", "1 2 3\n1 2\n");
  EXPECT_EQ(Ariadne("convert bad.xyz a.ply").status, 1);
  EXPECT_EQ(Content("a.ply"), "old");
}

using InfoCommand = ProgramTest;

TEST_F(InfoCommand, TellsWhatIsInAFolder) {
  WriteTwoScans("scans");
  EXPECT_EQ(Ariadne("info scans").err, "");
  const std::string out = Must("info scans");
  EXPECT_THAT(out, HasSubstr("2 scans, 6000 points\n"));
  EXPECT_THAT(out, HasSubstr("first guesses of the poses from .pose files in scans\n"));
  EXPECT_THAT(out, ContainsRegex("\nscan000 +3000 "));
}

TEST_F(InfoCommand, TellsWhatIsSuspicious) {
  std::string no_returns, on_the_robot, twice;
  for (int i = 0; i < 50; ++i) {
    no_returns += fmt::format("{} 81.91 0\n", 0.001 * i);
    on_the_robot += fmt::format("0.1 0.05 {}\n", 0.001 * i);
    twice += "1.5 1.5 1.5\n";
  }
  std::string wall;
  for (int i = 0; i < 1000; ++i) wall += fmt::format("4 {} {}\n", 0.1 * (i % 40), 0.1 * (i / 40));
  folder_.Write("in/scan0.xyz", wall);
  folder_.Write("in/scan1.xyz", wall + no_returns);
  folder_.Write("in/scan2.xyz", wall + on_the_robot);
  folder_.Write("in/scan3.xyz", wall + twice);
  const std::string out = Must("info in");
  EXPECT_THAT(out, ContainsRegex("\nscan0 [^\n]* -\n"));
  EXPECT_THAT(out, ContainsRegex("\nscan1 [^\n]*4.8 % at 81.91 m, the largest range: no-returns\n"));
  EXPECT_THAT(out, ContainsRegex("\nscan2 [^\n]*4.8 % nearer than 0.2 m\n"));
  EXPECT_THAT(out, ContainsRegex("\nscan3 [^\n]* % repeated points\n"));
  EXPECT_THAT(out, HasSubstr("no poses beside the scans"));
}

TEST_F(InfoCommand, NeedsNoFilesForTheOffice) {
  EXPECT_THAT(Must("info builtin:office"),
              AllOf(HasSubstr("8 scans, 370688 points"), HasSubstr("\nscan007 ")));
}

using RunFiles = ProgramTest;

TEST_F(RunFiles, TheMapIsAPlyOfTheSizeThatItsHeaderSays) {
  Must("register builtin:office --out run" + kSmall);
  const std::string ply = Content("run/map.ply");
  const std::size_t end = ply.find("end_header\n");
  ASSERT_NE(end, std::string::npos);
  const std::string header = ply.substr(0, end);
  EXPECT_THAT(header, testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(header, HasSubstr("element vertex 8784\n")) << "3 scans of 61 x 48 points";
  std::size_t stride = 0;
  std::istringstream words(header);
  for (std::string word; words >> word;) {
    if (word != "property") continue;
    words >> word;
    stride += word == "uchar" ? 1 : 4;
    EXPECT_THAT(word, testing::AnyOf("float", "uchar", "int"));
  }
  EXPECT_EQ(ply.size(), end + std::string("end_header\n").size() + 8784 * stride);
  EXPECT_THAT(Must("convert run/map.ply map.xyz"), HasSubstr("map.xyz: 8784 points"));
}

TEST_F(RunFiles, OfPosesStartTheNextRunWhereThisHasEnded) {
  WriteTwoScans("scans");
  Must("register scans --out run --set output.figures=false -q");
  for (const std::string poses : {"trajectory.tum", "poses.txt"}) {
    Must("register scans --set input.poses=run/" + poses + " --set output.figures=false -q --out " + poses);
    const auto metrics = nlohmann::json::parse(Content(poses + "/metrics.json"));
    const double after =
        nlohmann::json::parse(Content("run/metrics.json"))["median_plane_distance_after_m"];
    EXPECT_NEAR(metrics["median_plane_distance_before_m"], after, 1e-6) << poses;
  }
}

}  // namespace
}  // namespace ariadne
