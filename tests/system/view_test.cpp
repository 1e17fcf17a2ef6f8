#include <gmock/gmock.h>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::HasSubstr;
using testing::Not;

using ViewCommand = ProgramTest;

constexpr const char* kNoDisplay = "unset DISPLAY WAYLAND_DISPLAY; ";

TEST_F(ViewCommand, PrintsWhereTheReportIs) {
  Must("register builtin:office --out run" + kSmall);
  const Ended ended = Shell(std::string(kNoDisplay) + "ariadne view run");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out, "run/report.html\n");
  EXPECT_EQ(ended.err, "");
}

TEST_F(ViewCommand, OpensTheReportWhereThereIsADisplay) {
  Must("register builtin:office --out run" + kSmall);
  folder_.Write("bin/xdg-open", "#!/bin/sh\necho \"$1\" >opened.part && mv opened.part opened\n");
  const std::string display = "chmod +x bin/xdg-open; export PATH=\"$PWD/bin:$PATH\" DISPLAY=:0; ";
  EXPECT_EQ(Shell(display + "ariadne view run --no-open; sleep 0.2; test ! -e opened").status, 0);
  EXPECT_EQ(
      Shell(display + "ariadne view run; for i in $(seq 100); do test -e opened && break; sleep 0.1; done")
          .status,
      0);
  EXPECT_EQ(Content("opened"), "run/report.html\n");
}

TEST_F(ViewCommand, SaysWhyThereIsNoReport) {
  Must("register builtin:office --out run" + kSmall);
  fs::remove(folder_ / "run/report.html");
  const Ended ended = Shell(std::string(kNoDisplay) + "ariadne view run");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("run: there is no report.html, because the run has not finished"));
}

TEST_F(ViewCommand, DrawsAPictureWhereItIsAskedFor) {
  Must("register builtin:office --out run" + kSmall);
  EXPECT_THAT(Must("view run --out map.png --set width=200"), testing::StartsWith("map.png: 200 x "));
  Must("view run --set width=200 --out again.png");
  EXPECT_EQ(Content("map.png"), Content("again.png"));
  EXPECT_THAT(Must("view builtin:robobench --set width=200"), testing::StartsWith("view.png: 200 x "));
  const Ended ended = Ariadne("view run --set width=200");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("--set says how to draw a picture, and needs --out"));
}

TEST_F(ViewCommand, ShowsTheMapIn3D) {
  std::string figures = kSmall;
  figures.replace(figures.find("figures=false"), 13, "figures=true");
  Must("register builtin:office --out run" + figures);
  EXPECT_THAT(Content("run/report.html"), HasSubstr("<h2>The map in 3D</h2>"));
  Must("register builtin:office --out plain" + kSmall);
  EXPECT_THAT(Content("plain/report.html"), Not(HasSubstr("in 3D")));
}

}  // namespace
}  // namespace ariadne
