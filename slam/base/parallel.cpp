#include "slam/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "slam/base/error.h"

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#include <sanitizer/tsan_interface.h>
#define ARIADNE_TSAN 1
#endif
#endif

namespace ariadne {
namespace {

// What TBB promises, told to the thread sanitizer, which cannot see into a library that is not built for
// it: all before the loop happens before each body, and each body before all after the loop. Bodies are not
// ordered among each other, so that races between them are still found.
#ifdef ARIADNE_TSAN
char before_bodies, after_bodies;
void LoopBegins() { __tsan_release(&before_bodies); }
void BodyBegins() { __tsan_acquire(&before_bodies); }
void BodyEnds() { __tsan_release(&after_bodies); }
void LoopEnded() { __tsan_acquire(&after_bodies); }
#else
void LoopBegins() {}
void BodyBegins() {}
void BodyEnds() {}
void LoopEnded() {}
#endif

}  // namespace

struct Parallel::Arena {
  explicit Arena(int threads) : tbb_arena(threads) {}
  tbb::task_arena tbb_arena;
};

Parallel::Parallel(int threads) : threads_(threads) {
  if (threads < 1) Fail("the number of threads must be at least 1, not {}", threads);
  if (threads > 1) arena_ = std::make_unique<Arena>(threads);
}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

void Parallel::For(std::size_t count, std::size_t chunk_size, const Body& body) const {
  const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
  const auto run = [&](std::size_t chunk) {
    body(chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size), chunk);
  };
  if (!arena_ || chunks < 2) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
    return;
  }
  const auto run_ordered = [&](std::size_t chunk) {
    BodyBegins();
    run(chunk);
    BodyEnds();
  };
  LoopBegins();
  arena_->tbb_arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run_ordered); });
  LoopEnded();
}

}  // namespace ariadne
