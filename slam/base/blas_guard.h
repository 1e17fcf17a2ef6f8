#pragma once

#include <mutex>

namespace ariadne {

/// Who calls BLAS, or CHOLMOD or Ceres, which call it, holds one of these meanwhile.
///
/// Only one thread does at a time: Debian's OpenBLAS without threads gives two threads that call it at once
/// the same buffer, and what they compute is wrong, now and then. And no loop of OpenMP that this thread
/// enters starts other threads: CHOLMOD has such loops and asks for threads whatever the environment says;
/// on small factors they cost more than they bring.
class BlasGuard {
 public:
  BlasGuard();
  ~BlasGuard();
  BlasGuard(const BlasGuard&) = delete;
  BlasGuard& operator=(const BlasGuard&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  int max_active_levels_;
};

}  // namespace ariadne
