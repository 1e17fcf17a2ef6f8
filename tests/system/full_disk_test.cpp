#include <gmock/gmock.h>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::HasSubstr;

class FullDisk : public ProgramTest {
 protected:
  void SetUp() override {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  }
};

TEST_F(FullDisk, IsToldWhereAFileCannotBeWritten) {
  folder_.Write("a.xyz", "1 2 3\n");
  for (const char* name : {"full.ply", "full.xyz", "full.pcd", "full.bin", "full.3d"}) {
    fs::create_symlink("/dev/full", folder_ / name);
    const Ended ended = Ariadne(std::string("convert a.xyz ") + name);
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(ended.err,
              std::string("ariadne: ") + name +
                  ": cannot be written: No space left on device; free some space or choose another "
                  "disk\n");
  }
}

TEST_F(FullDisk, IsToldWhereTheOutputCannotBeWritten) {
  for (const char* arguments : {"config register", "config --describe", "--help", "info builtin:office"}) {
    const Ended ended = Shell(std::string("ariadne ") + arguments + " >/dev/full");
    EXPECT_EQ(ended.status, 1) << arguments;
    EXPECT_THAT(ended.err, testing::MatchesRegex("ariadne: [^\n]+: No space left on device\n"));
  }
}

TEST_F(FullDisk, EndsARunThatSaysSo) {
  // A limit on the size of files stands for the disk: the map has 440 kB.
  const Ended ended =
      Shell("trap '' XFSZ; ulimit -f 100; ariadne register builtin:office --out run" + kSmall);
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("ariadne: run/map.ply: cannot be written: File too large;"));
  EXPECT_THAT(Content("run/progress.json"), HasSubstr("\"state\": \"failed\""));
  EXPECT_FALSE(fs::exists(folder_ / "run/map.ply"));
  for (const auto& [name, content] : FilesOf("run")) {
    EXPECT_THAT(name, testing::Not(testing::EndsWith(".partial")));
  }
  Must("register --resume --out run -q");
  Must("register builtin:office --out whole" + kSmall);
  ExpectSameFiles("whole", "run");
}

TEST_F(FullDisk, OfRealSizeIsToldToo) {
  if (Shell("unshare -rm mount -t tmpfs tmpfs .").status != 0)
    GTEST_SKIP() << "no small disk can be mounted";
  fs::create_directories(folder_ / "disk");
  const Ended ended = Shell("unshare -rm sh -c 'mount -t tmpfs -o size=100k tmpfs disk && " ARIADNE_PROGRAM
                            " register builtin:office --out disk/run" +
                            kSmall + "'");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err,
              testing::MatchesRegex("ariadne: disk/run/[^\n]*: cannot be written: No space left on "
                                    "device[^\n]*\n"));
}

}  // namespace
}  // namespace ariadne
