#include "slam/base/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne {
namespace {

class ParallelWithThreads : public testing::TestWithParam<int> {
 protected:
  const Parallel parallel_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Threads, ParallelWithThreads, testing::Values(1, 2, 3, 8));

struct Cut {
  std::size_t count;
  std::size_t chunk_size;
};
constexpr Cut kCuts[] = {{1, 1},  {1, 100},  {10, 3},      {12, 3},
                         {13, 3}, {1000, 7}, {1000, 1000}, {1001, 1000}};

TEST_P(ParallelWithThreads, CoversEveryIndexExactlyOnce) {
  for (const Cut& cut : kCuts) {
    std::vector<std::atomic<int>> visits(cut.count);
    parallel_.For(cut.count, cut.chunk_size, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) ++visits.at(i);
    });
    EXPECT_TRUE(std::ranges::all_of(visits, [](const auto& n) { return n == 1; }))
        << cut.count << "/" << cut.chunk_size;
  }
}

TEST_P(ParallelWithThreads, CutsChunksOfTheGivenSizeWhateverTheThreads) {
  for (const Cut& cut : kCuts) {
    std::vector<std::atomic<int>> calls((cut.count + cut.chunk_size - 1) / cut.chunk_size);
    parallel_.For(cut.count, cut.chunk_size, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      EXPECT_EQ(begin, chunk * cut.chunk_size);
      EXPECT_EQ(end, std::min(begin + cut.chunk_size, cut.count));
      ++calls.at(chunk);
    });
    EXPECT_TRUE(std::ranges::all_of(calls, [](const auto& n) { return n == 1; }))
        << cut.count << "/" << cut.chunk_size;
  }
}

TEST_P(ParallelWithThreads, DoesNothingForZeroCount) {
  parallel_.For(0, 10, [](std::size_t, std::size_t, std::size_t) { FAIL() << "called without work"; });
  EXPECT_EQ(parallel_.Reduce(0, 10, 42.0, [](std::size_t, std::size_t) { return 1.0; }), 42.0);
}

/// Numbers of very different size, whose sum depends on the order of the additions.
std::vector<double> WildNumbers(std::size_t count) {
  RandomStream stream = NamedStream(1, "parallel_test/wild");
  std::vector<double> numbers(count);
  for (double& x : numbers) {
    const double size = std::exp2(DrawUniform(stream, 0.0, 40.0));
    x = DrawNormal(stream, 0.0, size);
  }
  return numbers;
}

TEST_P(ParallelWithThreads, ReducesToTheBytesOfTheSerialLeftFold) {
  constexpr std::size_t kChunk = 16;
  const std::vector<double> x = WildNumbers(10'007);
  const auto sum_of_range = [&](std::size_t begin, std::size_t end) {
    return std::accumulate(x.begin() + static_cast<std::ptrdiff_t>(begin),
                           x.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
  };
  double serial = 0.0;
  double backwards = 0.0;
  for (std::size_t begin = 0; begin < x.size(); begin += kChunk) {
    serial += sum_of_range(begin, std::min(begin + kChunk, x.size()));
  }
  for (std::size_t begin = x.size() / kChunk * kChunk + kChunk; begin > 0; begin -= kChunk) {
    backwards += sum_of_range(begin - kChunk, std::min(begin, x.size()));
  }
  ASSERT_NE(serial, backwards) << "the numbers must be able to show a wrong order";
  for (int repeat = 0; repeat < 20; ++repeat) {
    const double sum = parallel_.Reduce(x.size(), kChunk, 0.0, sum_of_range);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(sum), std::bit_cast<std::uint64_t>(serial));
  }
}

TEST_P(ParallelWithThreads, BringsAnExceptionOfTheBodyToTheCaller) {
  const auto fail_in_one_chunk = [](std::size_t begin, std::size_t, std::size_t chunk) {
    if (chunk == 5) Fail("point {} is not finite", begin);
  };
  try {
    parallel_.For(100, 10, fail_in_one_chunk);
    FAIL() << "the exception was swallowed";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "point 50 is not finite");
  }
  const auto length = [](std::size_t begin, std::size_t end) { return end - begin; };
  EXPECT_EQ(parallel_.Reduce(100, 10, std::size_t{0}, length), 100u) << "unusable after the exception";
}

TEST_P(ParallelWithThreads, NeverRunsOnMoreThreadsThanGiven) {
  std::atomic<int> running = 0;
  std::atomic<int> most = 0;
  parallel_.For(64, 1, [&](std::size_t, std::size_t, std::size_t) {
    const int now = ++running;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    --running;
  });
  EXPECT_LE(most, parallel_.threads());
}

TEST(Parallel, RunsInTheCallingThreadInOrderWithOneThread) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  Parallel(1).For(50, 10, [&](std::size_t, std::size_t, std::size_t chunk) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(chunk);
  });
  EXPECT_THAT(order, testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST(Parallel, LetsTwoChunksMeetWithTwoThreads) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  using Clock = std::chrono::steady_clock;
  const Clock::time_point give_up = Clock::now() + std::chrono::seconds(20);
  std::atomic<int> arrived = 0;
  Parallel(2).For(2, 1, [&](std::size_t, std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 2 && Clock::now() < give_up) std::this_thread::yield();
    EXPECT_EQ(arrived, 2) << "the second chunk waits for the end of the first";
  });
}

TEST(Parallel, WorksAfterAMove) {
  Parallel first(2);
  Parallel second(std::move(first));
  second = Parallel(3);
  EXPECT_EQ(second.threads(), 3);
  EXPECT_EQ(second.Reduce(9, 2, 0, [](std::size_t b, std::size_t e) { return static_cast<int>(e - b); }),
            9);
}

TEST(Parallel, RefusesFewerThanOneThreadWithASentence) {
  for (const int threads : {0, -1, -1000}) {
    try {
      Parallel parallel(threads);
      FAIL() << threads << " threads were accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "the number of threads must be at least 1, not " + std::to_string(threads));
    }
  }
}

}  // namespace
}  // namespace ariadne
