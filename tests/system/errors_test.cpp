// What a user does wrong: a sentence that says where and what, and a status that a script can see.
#include <gmock/gmock.h>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder in which all is wrong that can be.
class ErrorsTest : public ProgramTest {
 protected:
  ErrorsTest() {
    for (const char* name : {"good", "nan", "truncated", "text", "no_pose", "bad_pose"})
      WriteTwoScans(name);
    const std::string scan = CornerInCentimetres(0);
    folder_.Write("nan/scan001.3d", "1 2 3\n1 nan 3\n" + scan);
    folder_.Write("truncated/scan001.3d", scan + "100 2");
    folder_.Write("text/scan001.3d", "1 2 3\n1 2 3\n1 2 three\n");
    fs::remove(folder_ / "no_pose/scan001.pose");
    folder_.Write("bad_pose/scan001.pose", "0 0 0\n0 inf 0\n");
    folder_.Write("empty/README.txt", "nothing here");
    folder_.Write("unknown.yaml", "experiment: register\nicp:\n  max_distnace: 0.5\n");
    folder_.Write("repeated.yaml", "experiment: register\nicp:\n  trim: 0.5\n  trim: 0.6\n");
    folder_.Write("type.yaml", "experiment: register\nreduce:\n  voxel_size: small\n");
    folder_.Write("range.yaml", "experiment: register\n\nscan: {min_range: -1}\n");
    folder_.Write("name.yaml", "# mine\nexperiment: regsiter\n");
    folder_.Write("missing.yaml", "icp:\n  trim: 0.5\n");
  }
};

struct Mistake {
  std::string name;
  std::string arguments;
  std::string sentence;  // after "ariadne: ", from its beginning
};

class Mistakes : public ErrorsTest, public testing::WithParamInterface<Mistake> {};
INSTANTIATE_TEST_SUITE_P(
    Of, Mistakes,
    testing::Values(
        Mistake{"MissingFolder", "register none --out run",
                "none: there is no such folder; check the path"},
        Mistake{"FolderWithoutScans", "register empty --out run", "empty: holds no scans"},
        Mistake{"NaN", "register nan --out run",
                "nan/scan001.3d:2: the point has a coordinate that is NaN"},
        Mistake{"TruncatedScan", "register truncated --out run",
                "truncated/scan001.3d:3001: found 2 numbers"},
        Mistake{"TextInANumber", "register text --out run", "text/scan001.3d:3: "},
        Mistake{"MissingPose", "register no_pose --out run", "no_pose/scan001.pose: is missing"},
        Mistake{"BadPose", "register bad_pose --out run", "bad_pose/scan001.pose:2: "},
        Mistake{"MissingPoseFile", "register good --set input.poses=p.txt --out run",
                "p.txt: there is no such file"},
        Mistake{"UnknownKey", "run unknown.yaml",
                "unknown.yaml:3: unknown key icp.max_distnace; did you mean icp.max_distance?"},
        Mistake{"RepeatedKey", "run repeated.yaml",
                "repeated.yaml:4: the key icp.trim is repeated; it stands already at repeated.yaml:3"},
        Mistake{"WrongType", "run type.yaml",
                "type.yaml:3: reduce.voxel_size must be a number, not 'small'"},
        Mistake{"OutOfRange", "run range.yaml",
                "range.yaml:3: scan.min_range must be in 0 to 1000 m, not -1"},
        Mistake{"UnknownExperiment", "run name.yaml",
                "name.yaml:2: there is no experiment 'regsiter'; there are "},
        Mistake{"NoExperiment", "run missing.yaml", "missing.yaml: the key experiment is missing"},
        Mistake{"MissingConfig", "run none.yaml", "none.yaml: cannot open the config"},
        Mistake{"FolderAsConfig", "register --config good --out run", "good: is a folder, not a config"},
        Mistake{"BadAssignment", "register good --set icp.trim --out run",
                "--set icp.trim: expected key=value"},
        Mistake{"WrongAssignment", "register good --set icp.trim=7 --out run",
                "--set icp.trim=7: icp.trim must be in 0.05 to 1, not 7"},
        Mistake{"UnknownMethod", "register good --method best --out run",
                "--set registration.method=best: registration.method must be one of pairwise, metascan, "},
        Mistake{"WrongFormat", "register good --format ply --out run",
                "good: holds no scans of the format ply"},
        Mistake{"NothingToRegister", "register --out run", "which scans? "},
        Mistake{"NothingToResume", "register --resume --out run", "run: there is no run to resume"},
        Mistake{"OutIsNoRun", "register good --out empty --overwrite",
                "empty: exists and is not a run directory"},
        Mistake{"OneOutForTwo", "run unknown.yaml type.yaml --out run",
                "--out names one run directory, but there are 2"},
        Mistake{"ConvertNothing", "convert none.3d out.ply", "none.3d: there is no such file"},
        Mistake{"ConvertToUnknown", "convert good/scan000.3d out.las",
                "out.las: the extension does not tell the format"},
        Mistake{"ConvertToBadEncoding", "convert good/scan000.3d out.bin --encoding ascii",
                "out.bin: the format kitti has no such encoding"},
        Mistake{"ConvertIntoNowhere", "convert good/scan000.3d no/out.ply",
                "no/out.ply: cannot be written: No such file"},
        Mistake{"InfoOfNothing", "info none", "none: there is no such folder"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST_P(Mistakes, EndInOneSentenceAndStatusOne) {
  const Ended ended = Ariadne(GetParam().arguments + (GetParam().arguments.starts_with("r") ? " -q" : ""));
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, StartsWith("ariadne: " + GetParam().sentence));
  EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  EXPECT_FALSE(fs::exists(folder_ / "out.ply"));
}

TEST_F(ErrorsTest, OfArgumentsHaveStatusTwo) {
  EXPECT_EQ(Ariadne("").status, 2);
  EXPECT_EQ(Ariadne("register good").status, 2) << "--out is missing";
  EXPECT_EQ(Ariadne("register good --out run --fast").status, 2);
  EXPECT_EQ(Ariadne("register good --out run --resume --overwrite").status, 2);
  const Ended unknown = Ariadne("regsiter good");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(
      unknown.err,
      StartsWith("there is no command 'regsiter'; there are explore, register, optimize, run, emulate, "
                 "convert, info, config, simulate, extract, map, plan, export, view, devices, log, replay, "
                 "calibrate, check\n"));
  EXPECT_FALSE(fs::exists(folder_ / "run"));
}

TEST_F(ErrorsTest, InTheInputLeaveNoRunAndDestroyNone) {
  EXPECT_EQ(Ariadne("register none --out run -q").status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "run"));
  Must("register good --out run" + kSmall + "--set input.last=1");
  EXPECT_EQ(Ariadne("register none --out run --overwrite -q").status, 1);
  EXPECT_EQ(Ariadne("register good --set icp.trim=7 --out run --overwrite -q").status, 1);
  EXPECT_THAT(Content("run/progress.json"), HasSubstr("\"state\": \"finished\""));
  EXPECT_EQ(Ariadne("run '" ARIADNE_SOURCE_DIR "/experiments/configs/fig_05.yaml' --set input.folder=none")
                .status,
            1);
  EXPECT_FALSE(fs::exists(folder_ / "results"));
}

TEST_F(ErrorsTest, DuringARunAreNotedInIt) {
  const Ended ended = Ariadne("register truncated --out run -q");
  EXPECT_EQ(ended.status, 1);
  const std::string progress = Content("run/progress.json");
  EXPECT_THAT(progress, HasSubstr("\"state\": \"failed\""));
  EXPECT_THAT(progress, HasSubstr("\"done\": 1,"));
  EXPECT_THAT(progress, HasSubstr("truncated/scan001.3d:3001: "));
}

TEST_F(ErrorsTest, ARunIsNotOverwrittenUnasked) {
  const std::string options = kSmall + "--set input.last=1 ";
  Must("register good --out run" + options);
  const Ended ended = Ariadne("register good --out run" + options);
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err,
              EndsWith("run: holds a run already; choose another --out, or add --overwrite or --resume\n"));
  Must("register good --out run --overwrite" + options);
}

TEST_F(ErrorsTest, ScansThatAreNotRegisteredAreStatusOneInEitherCommand) {
  folder_.Write("my.yaml", "experiment: register\n");
  const std::string options = " --set registration.overlap_pairs=100000" + kSmall;
  for (const char* command : {"register builtin:office --out a", "run my.yaml --out b"}) {
    const Ended ended = Ariadne(command + options);
    EXPECT_EQ(ended.status, 1) << command;
    EXPECT_EQ(ended.err, "ariadne: 2 of 3 scans could not be registered; scans.csv says why\n");
    EXPECT_THAT(ended.out, HasSubstr("results in ")) << "the others are there";
  }
}

}  // namespace
}  // namespace ariadne
