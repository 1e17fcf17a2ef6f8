#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "slam/base/error.h"

namespace ariadne::drivers {

/// What crosses a line.
using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// Appends the fields of a telegram to its bytes. WireReader has the same functions, so that the fields of
/// a telegram are listed once for both directions. Words are little-endian.
class WireWriter {
 public:
  void Byte(std::uint8_t value) { bytes_.push_back(value); }
  void Word(std::uint16_t value) {
    Byte(static_cast<std::uint8_t>(value & 0xFF));
    Byte(static_cast<std::uint8_t>(value >> 8));
  }
  void Text(const std::string& text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
  void Rest(const Bytes& bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  Bytes Finish() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

/// Takes the fields of a telegram from its bytes. Bytes that end too early, or later than the fields, are
/// an Error.
class WireReader {
 public:
  explicit WireReader(ByteView bytes) : bytes_(bytes) {}

  void Byte(std::uint8_t& value) { value = Next(1)[0]; }
  void Word(std::uint16_t& value) {
    const ByteView bytes = Next(2);
    value = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
  }
  /// All that is left.
  void Text(std::string& text) {
    const ByteView rest = Next(bytes_.size());
    text.assign(rest.begin(), rest.end());
  }
  void Rest(Bytes& bytes) {
    const ByteView rest = Next(bytes_.size());
    bytes.assign(rest.begin(), rest.end());
  }

  std::size_t size() const { return bytes_.size(); }  // what is left
  void Finish() const {
    if (!bytes_.empty()) Fail("a telegram is {} bytes longer than its fields", bytes_.size());
  }

 private:
  ByteView Next(std::size_t count) {
    if (bytes_.size() < count) {
      Fail("a telegram ends {} bytes before its fields do", count - bytes_.size());
    }
    const ByteView next = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return next;
  }

  ByteView bytes_;
};

}  // namespace ariadne::drivers
