#include "experiments/field/terminal.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace ariadne::experiments {
namespace {

constexpr int kAskPeriod = 100;  // between questions whether to stop [ms]

}  // namespace

Terminal::Terminal(int descriptor) : descriptor_(descriptor) {
  // From the background, reading would stop the program, and setting would change another one's terminal.
  if (isatty(descriptor_) == 0 || tcgetpgrp(descriptor_) != getpgrp()) return;
  auto before = std::make_unique<termios>();
  if (tcgetattr(descriptor_, before.get()) != 0) return;
  termios keys = *before;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  if (tcsetattr(descriptor_, TCSANOW, &keys) == 0) before_ = std::move(before);
}

Terminal::~Terminal() {
  if (before_) tcsetattr(descriptor_, TCSANOW, before_.get());
}

Terminal::Input Terminal::Next(int milliseconds, char& key) {
  pollfd input{descriptor_, POLLIN, 0};
  if (poll(&input, 1, milliseconds) <= 0) return Input::kNothing;  // also where a signal came
  if ((input.revents & (POLLIN | POLLHUP | POLLERR | POLLNVAL)) == 0) return Input::kNothing;
  return read(descriptor_, &key, 1) == 1 ? Input::kKey : Input::kEnd;
}

const std::string& Terminal::StopReason() {
  if (!reason_.empty() || !IsWatched()) return reason_;
  char key = 0;
  const Input input = Next(0, key);
  if (input == Input::kKey) reason_ = "a key was pressed";
  if (input == Input::kEnd) reason_ = "the terminal is gone";
  return reason_;
}

std::optional<char> Terminal::Ask(std::string_view keys, const std::function<bool()>& stop) {
  while (!(stop && stop())) {
    char key = 0;
    const Input input = Next(kAskPeriod, key);
    if (input == Input::kEnd) {
      if (reason_.empty()) reason_ = "the terminal is gone";
      return std::nullopt;
    }
    if (input == Input::kKey && keys.find(key) != std::string_view::npos) return key;
  }
  return std::nullopt;
}

}  // namespace ariadne::experiments
