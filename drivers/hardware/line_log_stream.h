#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/hardware/recorded_stream.h"

namespace ariadne::drivers {

/// A record of a line among others.
struct LoggedRecord {
  std::uint8_t line = 0;
  LineRecord record;

  bool operator==(const LoggedRecord&) const = default;
};

/// Makes the bytes of a file of a log, all numbers little-endian:
///     8 bytes  "ARIADLN2"
///     records, until the end of the file:
///       uint32   length of the chunk [B]
///       uint32   CRC-32 (of zlib, Ethernet) of these four bytes of length and the chunk
///       chunk    of one zstd stream over the whole file, flushed, so that each chunk ends a record:
///                uint8 line, uint8 kind, f64 time [s], int32 baud, and the bytes read or written
/// The stream remembers what came before, and most of what crosses a line has; flushing costs a few bytes
/// per record, and buys that none waits in memory for another.
class LineLogEncoder {
 public:
  static constexpr std::size_t kHeadSize = 8;  // [B]

  LineLogEncoder();
  ~LineLogEncoder();

  /// Begins a file: its first bytes.
  Bytes Begin();
  Bytes Add(const LoggedRecord& logged);

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// Takes a file of a log apart. What is damaged ends it, since all that follows hangs on it.
class LineLogDecoder {
 public:
  /// The bytes must outlive it. Error where they are the beginning of something else.
  explicit LineLogDecoder(ByteView file);
  ~LineLogDecoder();

  /// The next record; none where no whole one follows.
  std::optional<LoggedRecord> Next();

  /// Where the last whole record ends [B].
  std::size_t position() const { return position_; }

 private:
  struct Stream;
  ByteView file_;
  std::size_t position_ = 0;
  std::unique_ptr<Stream> stream_;
};

}  // namespace ariadne::drivers
