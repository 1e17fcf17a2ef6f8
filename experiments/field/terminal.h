#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct termios;

namespace ariadne::experiments {

/// The terminal of who watches a robot. While it lives, keys arrive one by one and are not shown. What is
/// no terminal (a file, a pipe) can answer questions, but is not watched; neither is a terminal whose
/// foreground another program has.
class Terminal {
 public:
  explicit Terminal(int descriptor = 0);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool IsWatched() const { return before_ != nullptr; }

  /// Why the robot must stop, as far as this terminal is concerned: a key was pressed, or the terminal is
  /// gone. Empty as long as all is well, and where nobody watches. It latches.
  const std::string& StopReason();

  /// Waits for one of the keys; others are passed over, keys pressed before count. None when the terminal,
  /// or the input, has ended, or `stop` says so.
  std::optional<char> Ask(std::string_view keys, const std::function<bool()>& stop);

 private:
  enum class Input { kNothing, kKey, kEnd };
  Input Next(int milliseconds, char& key);

  int descriptor_;
  std::unique_ptr<termios> before_;
  std::string reason_;
};

}  // namespace ariadne::experiments
