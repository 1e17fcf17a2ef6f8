#include "slam/io/scalar.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace ariadne::slam {
namespace {

/// Calls use(T{}) with the C++ type of a scalar.
template <typename Use>
auto WithType(ScalarType type, const Use& use) {
  switch (type) {
    case ScalarType::kInt8:
      return use(std::int8_t{});
    case ScalarType::kUint8:
      return use(std::uint8_t{});
    case ScalarType::kInt16:
      return use(std::int16_t{});
    case ScalarType::kUint16:
      return use(std::uint16_t{});
    case ScalarType::kInt32:
      return use(std::int32_t{});
    case ScalarType::kUint32:
      return use(std::uint32_t{});
    case ScalarType::kInt64:
      return use(std::int64_t{});
    case ScalarType::kUint64:
      return use(std::uint64_t{});
    case ScalarType::kFloat32:
      return use(float{});
    case ScalarType::kFloat64:
      break;
  }
  return use(double{});
}

template <typename T>
T Load(const char* bytes, bool big_endian) {
  std::array<char, sizeof(T)> ordered;
  std::memcpy(ordered.data(), bytes, sizeof(T));
  if (big_endian) std::reverse(ordered.begin(), ordered.end());
  return std::bit_cast<T>(ordered);
}

template <typename To>
void Copy(const Column& column, std::span<To> to, std::size_t step) {
  WithType(column.type, [&](auto example) {
    using From = decltype(example);
    const char* from = column.first;
    for (std::size_t i = 0; i < to.size(); i += step, from += column.stride) {
      to[i] = static_cast<To>(Load<From>(from, column.big_endian));
    }
  });
}

}  // namespace

std::size_t SizeOf(ScalarType type) {
  return WithType(type, [](auto example) { return sizeof(example); });
}

void CopyColumn(const Column& column, std::span<double> to, std::size_t step) { Copy(column, to, step); }
void CopyColumn(const Column& column, std::span<float> to, std::size_t step) { Copy(column, to, step); }

}  // namespace ariadne::slam
