// Who watches a robot on a terminal: the program on a pseudo-terminal, with keys as a person presses them.
#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>

#include "tests/system/program.h"
#include "tests/system/rooms.h"

namespace ariadne {
namespace {

using testing::HasSubstr;

class Approve : public ProgramTest {
 protected:
  void SetUp() override {
    folder_.Write("rooms.json", kTwoRoomsPlan);
    folder_.Write("rooms.yaml", RoomsConfig(3));
  }
  void TearDown() override { HangUp(); }

  /// Starts a mission whose drives must be approved, with this terminal.
  void StartOnTerminal(const std::string& out) {
    said_.clear();
    child_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    ASSERT_GE(child_, 0);
    if (child_ > 0) return;
    if (chdir(folder_.path().c_str()) == 0)
      execl(ARIADNE_PROGRAM, "ariadne", "explore", "rooms.yaml", "--approve", "-q", "--out", out.c_str(),
            static_cast<char*>(nullptr));
    _exit(127);
  }

  /// Waits until the program says something; false where it ends, or says nothing for a minute.
  bool Hears(const std::string& text) {
    for (std::size_t at = said_.find(text); at == std::string::npos; at = said_.find(text)) {
      pollfd input{terminal_, POLLIN, 0};
      char bytes[512];
      const ssize_t count = poll(&input, 1, 60000) > 0 ? read(terminal_, bytes, sizeof bytes) : 0;
      if (count <= 0) return false;
      said_.append(bytes, static_cast<std::size_t>(count));
    }
    said_.erase(0, said_.find(text) + text.size());
    return true;
  }
  void Press(const std::string& keys) const {
    EXPECT_EQ(write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  void HangUp() {
    if (terminal_ >= 0) close(terminal_);
    terminal_ = -1;
  }
  int Status() {
    while (terminal_ >= 0 && Hears("\n")) {
    }
    int status = -1;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  long Scans(const std::string& run) const {
    const std::string stops = Content(run + "/stops.csv");
    return std::ranges::count(stops, '\n') - 1;
  }

  pid_t child_ = -1;
  int terminal_ = -1;
  std::string said_;
};

constexpr const char* kQuestion = "one key: y drives";

TEST_F(Approve, DrivesWhereAKeySaysSo) {
  StartOnTerminal("run");
  ASSERT_TRUE(Hears(kQuestion));
  Press("ay");  // other keys say nothing
  ASSERT_TRUE(Hears(kQuestion));
  Press("n");
  EXPECT_TRUE(Hears("a plan was not approved"));
  EXPECT_EQ(Status(), 0);
  EXPECT_EQ(Scans("run"), 2);
}

TEST_F(Approve, StopsAtAnyKey) {
  StartOnTerminal("run");
  ASSERT_TRUE(Hears(kQuestion));
  Press("y ");  // the second one while it drives
  EXPECT_TRUE(Hears("stopped; --resume goes on from here"));
  EXPECT_EQ(Status(), 1);
  EXPECT_EQ(Scans("run"), 1);
}

TEST_F(Approve, StopsWhereTheTerminalIsGone) {
  StartOnTerminal("run");
  ASSERT_TRUE(Hears(kQuestion));
  HangUp();
  EXPECT_EQ(Status(), 1);
  EXPECT_THAT(Content("run/progress.json"), HasSubstr("\"state\": \"stopped\""));
  EXPECT_EQ(Shell("echo yyyy | ariadne explore --resume --out run --approve -q").status, 0);
}

}  // namespace
}  // namespace ariadne
