#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <ostream>
#include <utility>

namespace ariadne::slam {

/// Collects text or bytes and passes them to a stream in large pieces.
class ChunkedOutput {
 public:
  explicit ChunkedOutput(std::ostream& out) : out_(out) {}

  template <typename... Args>
  void Print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(chunk_), format, std::forward<Args>(args)...);
    if (chunk_.size() >= kChunkSize) Flush();
  }

  /// The bytes of a number as they lie in memory.
  template <typename T>
  void PutBytes(const T& number) {
    const auto* bytes = reinterpret_cast<const char*>(&number);
    chunk_.append(bytes, bytes + sizeof(T));
    if (chunk_.size() >= kChunkSize) Flush();
  }

  /// Must be the last call.
  void Flush() {
    out_.write(chunk_.data(), static_cast<std::streamsize>(chunk_.size()));
    chunk_.clear();
  }

 private:
  static constexpr std::size_t kChunkSize = 1 << 18;  // [B]

  std::ostream& out_;
  fmt::memory_buffer chunk_;
};

}  // namespace ariadne::slam
