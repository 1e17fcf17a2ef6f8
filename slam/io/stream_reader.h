#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {

/// Reads a stream in large chunks, by lines and by bytes, and knows where it is, so that an error can
/// name the line or the byte. The views it returns are valid until the next call.
class StreamReader {
 public:
  /// No line may be longer, no block of bytes larger. [B]
  static constexpr std::size_t kChunkSize = 1 << 20;

  /// `name` is the path or whatever else the messages should call the stream.
  StreamReader(std::istream& in, std::string name);

  const std::string& name() const { return name_; }
  /// The line that NextLine returned last, counted from 1.
  std::size_t line() const { return line_; }
  /// The byte that comes next, counted from 0.
  std::uint64_t offset() const { return offset_; }
  /// The bytes from offset() to the end; unknown for a pipe.
  std::optional<std::uint64_t> Remaining() const;

  /// The next line without its end (LF or CRLF; the last line may have none), or nothing at the end.
  std::optional<std::string_view> NextLine();
  /// What NextLine will return.
  std::optional<std::string_view> PeekLine();

  /// The next `count` <= kChunkSize bytes; fewer only where the stream ends.
  std::string_view NextBytes(std::size_t count);

  template <typename... Args>
  [[noreturn]] void FailAtLine(fmt::format_string<Args...> format, Args&&... args) const {
    Fail("{}:{}: {}", name_, line_, fmt::format(format, std::forward<Args>(args)...));
  }
  template <typename... Args>
  [[noreturn]] void FailAtByte(std::uint64_t byte, fmt::format_string<Args...> format,
                               Args&&... args) const {
    Fail("{}: byte {}: {}", name_, byte, fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  /// A line with its end: `size` bytes of which the first `text_size` are the line.
  struct LineExtent {
    std::size_t size;
    std::size_t text_size;
  };
  std::optional<LineExtent> FindLine();
  void FillBuffer();
  void Consume(std::size_t count);

  std::istream& in_;
  std::string name_;
  std::optional<std::uint64_t> size_;  // of the stream from where it stood at construction
  std::size_t capacity_;
  std::unique_ptr<char[]> buffer_;
  std::size_t begin_ = 0;  // what is read but not consumed is [begin_, end_)
  std::size_t end_ = 0;
  std::uint64_t offset_ = 0;
  std::size_t line_ = 0;
};

/// The number of line ends in the rest of the stream, which stays where it is; unknown for a pipe.
std::optional<std::size_t> CountLineEnds(std::istream& in);

/// A piece of a file for a message: shortened, in quotes, with unprintable bytes as \xNN.
std::string Quoted(std::string_view piece);

}  // namespace ariadne::slam
