#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "slam/base/error.h"

namespace ariadne::drivers {

static_assert(std::endian::native == std::endian::little,
              "logs are read and written as numbers lie in memory; they are little-endian");

/// Appends numbers to bytes. FieldReader has the same functions, so that the fields of a record are listed
/// once for both.
class FieldWriter {
 public:
  template <typename T>
  void Number(const T& number) {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void Flag(const bool& flag) { bytes_.push_back(flag ? '\1' : '\0'); }

  /// Their number, and then each of them.
  template <typename T, typename Fields>
  void List(const std::vector<T>& elements, const Fields& fields) {
    Number(static_cast<std::uint32_t>(elements.size()));
    for (const T& element : elements) fields(*this, element);
  }
  void Floats(const std::vector<float>& numbers);
  /// All that is left of the bytes.
  void Rest(const std::string& text) { bytes_ += text; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes numbers from bytes. Bytes that end too early, or later than the fields, are an Error.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  void Number(T& number) {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    std::memcpy(&number, Next(sizeof number).data(), sizeof number);
  }
  void Flag(bool& flag);
  template <typename T, typename Fields>
  void List(std::vector<T>& elements, const Fields& fields) {
    std::uint32_t count = 0;
    Number(count);
    elements.clear();  // and no reserve: the count may be a lie, which the end of the bytes brings to light
    for (; count > 0; --count) fields(*this, elements.emplace_back());
  }
  void Floats(std::vector<float>& numbers);
  void Rest(std::string& text) { text = Next(bytes_.size()); }

  /// Error unless all bytes were taken.
  void Finish() const;

 private:
  std::string_view Next(std::size_t count);

  std::string_view bytes_;
};

}  // namespace ariadne::drivers
