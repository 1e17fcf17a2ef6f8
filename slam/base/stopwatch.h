#pragma once

#include <chrono>

namespace ariadne {

/// Wall-clock time since it was made. What it shows is the one thing in a result that is not deterministic.
class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ariadne
