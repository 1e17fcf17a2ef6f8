#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace ariadne::slam {

static_assert(std::endian::native == std::endian::little,
              "binary files are read and written as they lie in memory; they are little-endian");

static_assert(
    std::numeric_limits<float>::is_iec559,
    "a double that is too large for a float is converted to infinity, which the checks of points find");

/// How a binary file stores a number.
enum class ScalarType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// [B]
std::size_t SizeOf(ScalarType type);

/// Numbers of one kind that lie at equal distances in memory: a field of records, or an array.
struct Column {
  ScalarType type = ScalarType::kFloat32;
  const char* first = nullptr;
  std::size_t stride = 0;  // [B]
  bool big_endian = false;
};

/// Copies a column to every `step`-th element of `to`, from its first on, until `to` is filled.
void CopyColumn(const Column& column, std::span<double> to, std::size_t step);
void CopyColumn(const Column& column, std::span<float> to, std::size_t step);

}  // namespace ariadne::slam
