#include "slam/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne {

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
  arena_->tbb_arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run); });
}

}  // namespace ariadne
