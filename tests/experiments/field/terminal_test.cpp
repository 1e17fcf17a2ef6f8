#include "experiments/field/terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace ariadne::experiments {
namespace {

/// Runs `child` with a terminal of its own as its standard input; it ends with a status.
template <typename Child, typename Parent>
int WithTerminal(const Child& child, const Parent& parent) {
  int terminal = -1;
  const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (pid == 0) _exit(child());
  char ready = 0;
  EXPECT_EQ(read(terminal, &ready, 1), 1);
  parent(terminal);
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int Ready() { return write(1, "!", 1) == 1 ? 0 : 1; }

/// Asks for up to 5 s.
std::string ReasonOf(Terminal& terminal) {
  for (int i = 0; i < 500 && terminal.StopReason().empty(); ++i) usleep(10000);
  return terminal.StopReason();
}

TEST(Terminal, StopsByAKeyWithoutReturn) {
  const auto child = [] {
    Terminal terminal;
    if (!terminal.IsWatched() || !terminal.StopReason().empty() || Ready() != 0) return 1;
    return ReasonOf(terminal) == "a key was pressed" ? 0 : 2;
  };
  EXPECT_EQ(WithTerminal(child, [](int terminal) { EXPECT_EQ(write(terminal, " ", 1), 1); }), 0);
}

TEST(Terminal, StopsWhenItIsGone) {
  const auto child = [] {
    signal(SIGHUP, SIG_IGN);
    Terminal terminal;
    if (Ready() != 0) return 1;
    return ReasonOf(terminal) == "the terminal is gone" ? 0 : 2;
  };
  EXPECT_EQ(WithTerminal(child, [](int terminal) { close(terminal); }), 0);
}

TEST(Terminal, TakesTheAnswersThatAreAskedFor) {
  const auto child = [] {
    Terminal terminal;
    if (Ready() != 0) return 1;
    const bool right = terminal.Ask("yn", {}) == 'n' && terminal.StopReason().empty();
    return right && !terminal.Ask("yn", [] { return true; }) ? 0 : 2;
  };
  EXPECT_EQ(WithTerminal(child, [](int terminal) { EXPECT_EQ(write(terminal, "x\nn", 3), 3); }), 0);
}

TEST(Terminal, IsNotWatchedWhereItIsNone) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ASSERT_EQ(write(ends[1], "?y", 2), 2);
  Terminal terminal(ends[0]);
  EXPECT_FALSE(terminal.IsWatched());
  EXPECT_EQ(terminal.StopReason(), "");
  EXPECT_EQ(terminal.Ask("yn", {}), 'y');
  close(ends[1]);
  EXPECT_EQ(terminal.Ask("yn", {}), std::nullopt);
  EXPECT_EQ(terminal.StopReason(), "the terminal is gone");
  close(ends[0]);
}

}  // namespace
}  // namespace ariadne::experiments
