#pragma once

#include <cstdint>
#include <istream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "drivers/hardware/wire.h"
#include "slam/base/error.h"

namespace ariadne::fuzz {

inline drivers::ByteView ViewOf(std::string_view bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

inline std::string AllOf(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

template <typename Read>
auto ReadBytes(std::string_view bytes, const Read& read) {
  std::istringstream in{std::string(bytes)};
  return read(in, "input");
}

template <typename Write, typename Value>
std::string Written(const Write& write, const Value& value) {
  std::ostringstream out;
  write(out, value);
  return out.str();
}

/// Whether `read` accepts the bytes, and `write` can say what was read; then it must say it twice alike.
template <typename Read, typename Write>
bool Accepts(std::string_view bytes, const Read& read, const Write& write) {
  std::string first;
  try {
    first = Written(write, ReadBytes(bytes, read));
  } catch (const Error&) {
    return false;
  }
  if (Written(write, ReadBytes(first, read)) != first) {
    throw std::logic_error("written differently the second time");
  }
  return true;
}

}  // namespace ariadne::fuzz
