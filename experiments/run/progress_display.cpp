#include "experiments/run/progress_display.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace ariadne::experiments {

ProgressDisplay::ProgressDisplay(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::Show(const std::string& text) {
  constexpr double kInterval = 0.1;  // [s]
  if (quiet_ || !terminal_ || since_start_.Seconds() - last_shown_ < kInterval) return;
  last_shown_ = since_start_.Seconds();
  ClearLine();
  fmt::print(stderr, "{}", text);
  std::fflush(stderr);
  line_shown_ = true;
}

void ProgressDisplay::Keep(const std::string& text) {
  if (quiet_) return;
  ClearLine();
  if (!text.empty()) fmt::print(stderr, "{}\n", text);
}

std::string ProgressDisplay::Eta(double done_share) const {
  if (done_share <= 0.0) return "ETA ?";
  return fmt::format("ETA {:.0f} s", since_start_.Seconds() * (1.0 - done_share) / done_share);
}

void ProgressDisplay::ClearLine() {
  if (!line_shown_) return;
  fmt::print(stderr, "\r\033[K");
  line_shown_ = false;
}

}  // namespace ariadne::experiments
