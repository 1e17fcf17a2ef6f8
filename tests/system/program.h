#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/slam/io/support.h"

/// Runs the real program, as a user would in a shell.
namespace ariadne {

namespace fs = std::filesystem;

/// How a command has ended.
struct Ended {
  int status = -1;  // 128 + the signal where it was killed
  std::string out;
  std::string err;
};

/// Options with which the built-in office takes a fraction of a second.
inline const std::string kSmall =
    " --set input.office.beams=61 --set input.office.slices=48 --set input.last=2"
    " --set output.figures=false -q ";

/// The fixture of tests that run the program in a folder of their own.
class ProgramTest : public testing::Test {
 protected:
  /// A line for the shell, in which "ariadne" is the program.
  Ended Shell(const std::string& line) const {
    const std::string command =
        "cd '" + folder_.path().string() + "' && ariadne() { '" ARIADNE_PROGRAM "' \"$@\"; } && { " + line +
        "\n} >'" + (folder_ / ".out").string() + "' 2>'" + (folder_ / ".err").string() + "' </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), Content(".out"),
            Content(".err")};
  }
  /// Starts the program in the folder, without a shell between, so that it can be killed.
  pid_t Start(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), ARIADNE_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(folder_.path().c_str()) == 0) execv(argv[0], argv.data());
      _exit(127);
    }
    return child;
  }
  Ended Ariadne(const std::string& arguments) const { return Shell("ariadne " + arguments); }
  /// Runs what must succeed for the test to make sense.
  std::string Must(const std::string& arguments) const {
    const Ended ended = Ariadne(arguments);
    EXPECT_EQ(ended.status, 0) << "ariadne " << arguments << "\n" << ended.err;
    return ended.out;
  }

  std::string Content(const std::string& file) const {
    return slam::testing_support::ContentOf(folder_ / file);
  }
  /// All files of a run by their names, without timing.json, which may differ.
  std::map<std::string, std::string> FilesOf(const std::string& run) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / run)) {
      const std::string name = fs::relative(entry.path(), folder_ / run);
      if (entry.is_regular_file() && name != "timing.json") files[name] = Content(run + "/" + name);
    }
    return files;
  }
  /// The same bytes under the same names; tells which differ, instead of printing them.
  void ExpectSameFiles(const std::string& run_a, const std::string& run_b) const {
    const auto a = FilesOf(run_a), b = FilesOf(run_b);
    EXPECT_GT(a.size(), 10U) << "there is something to compare";
    for (const auto& [name, content] : a) {
      ASSERT_TRUE(b.contains(name)) << name << " is missing in " << run_b;
      EXPECT_TRUE(b.at(name) == content) << name << " differs";
    }
    EXPECT_EQ(a.size(), b.size());
  }
  /// A folder of two scans that overlap, uos format, with poses.
  void WriteTwoScans(const std::string& name) const;

  slam::testing_support::TemporaryFolder folder_;
};

/// Points of three walls, "x y z" in centimetres.
inline std::string CornerInCentimetres(int offset) {
  std::ostringstream text;
  for (int i = 0; i < 40; ++i) {
    for (int k = 0; k < 25; ++k) {
      const int a = 100 + 10 * i + offset, b = 100 + 10 * k;
      text << a << " " << b << " 400\n400 " << b << " " << a << "\n" << a << " 90 " << b << "\n";
    }
  }
  return text.str();
}

inline void ProgramTest::WriteTwoScans(const std::string& name) const {
  for (int i = 0; i < 2; ++i) {
    const std::string scan = name + "/scan00" + std::to_string(i);
    folder_.Write(scan + ".3d", CornerInCentimetres(3 * i));
    folder_.Write(scan + ".pose", "0 0 0\n0 0 0\n");
  }
}

}  // namespace ariadne
