#include "slam/base/blas_guard.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace ariadne {
namespace {

TEST(BlasGuard, LetsInOneThreadAtATime) {
  std::atomic<int> inside = 0, met = 0;
  const auto call = [&] {
    for (int i = 0; i < 200; ++i) {
      const BlasGuard guard;
      const BlasGuard again;  // of the same thread
      if (++inside > 1) ++met;
      std::this_thread::yield();
      --inside;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(call);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(met, 0);
}

}  // namespace
}  // namespace ariadne
