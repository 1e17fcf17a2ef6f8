#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace ariadne {

/// Runs loops on a given number of threads so that the result never depends on that number: work is cut
/// into chunks of a fixed size, and partial results are combined in the order of the chunks.
class Parallel {
 public:
  /// `threads` >= 1; with 1 everything runs in the calling thread.
  explicit Parallel(int threads);
  ~Parallel();
  Parallel(Parallel&&) noexcept;
  Parallel& operator=(Parallel&&) noexcept;

  int threads() const { return threads_; }

  using Body = std::function<void(std::size_t begin, std::size_t end, std::size_t chunk)>;

  /// Calls body(begin, end, chunk) for each chunk of [0, count); returns when all are done.
  void For(std::size_t count, std::size_t chunk_size, const Body& body) const;

  /// Folds the chunks of [0, count) in ascending order: sum += map(begin, end).
  template <typename T, typename Map>
  T Reduce(std::size_t count, std::size_t chunk_size, const T& zero, const Map& map) const {
    std::vector<T> partial((count + chunk_size - 1) / chunk_size, zero);
    For(count, chunk_size,
        [&](std::size_t begin, std::size_t end, std::size_t chunk) { partial[chunk] = map(begin, end); });
    T sum = zero;
    for (const T& part : partial) sum += part;
    return sum;
  }

 private:
  struct Arena;  // keeps TBB out of the headers
  int threads_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace ariadne
