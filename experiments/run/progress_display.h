#pragma once

#include <string>

#include "slam/base/stopwatch.h"

namespace ariadne::experiments {

/// Tells on stderr how far long work has come. On a terminal one line is kept up to date; elsewhere (a log
/// file) only finished steps are written.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool quiet);

  /// A passing state, at most ten times a second.
  void Show(const std::string& text);
  /// A finished step, which stays. An empty text only takes the passing state away.
  void Keep(const std::string& text);

  /// "ETA 12 s", from the share of the work that is done.
  std::string Eta(double done_share) const;

 private:
  void ClearLine();

  bool quiet_;
  bool terminal_;
  bool line_shown_ = false;
  Stopwatch since_start_;
  double last_shown_ = -1.0;  // [s]
};

}  // namespace ariadne::experiments
