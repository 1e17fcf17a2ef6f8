#include "slam/io/scalar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ariadne::slam {
namespace {

/// Two records of a byte and a number, in both byte orders, give the numbers.
template <typename T>
void ExpectCopies(ScalarType type, T first, T second) {
  EXPECT_EQ(SizeOf(type), sizeof(T));
  for (const bool big_endian : {false, true}) {
    std::string records;
    for (const T number : {first, second}) {
      std::string bytes(reinterpret_cast<const char*>(&number), sizeof(T));
      if (big_endian) std::reverse(bytes.begin(), bytes.end());
      records += "x" + bytes;
    }
    std::vector<double> to(4, 0.5);
    CopyColumn({type, records.data() + 1, 1 + sizeof(T), big_endian}, std::span(to).subspan(1), 2);
    EXPECT_EQ(to, (std::vector<double>{0.5, static_cast<double>(first), 0.5, static_cast<double>(second)}));
  }
}

TEST(CopyColumn, KnowsAllTypes) {
  ExpectCopies<std::int8_t>(ScalarType::kInt8, -128, 127);
  ExpectCopies<std::uint8_t>(ScalarType::kUint8, 200, 255);
  ExpectCopies<std::int16_t>(ScalarType::kInt16, -32768, 258);
  ExpectCopies<std::uint16_t>(ScalarType::kUint16, 65535, 258);
  ExpectCopies<std::int32_t>(ScalarType::kInt32, -70000, 16909060);
  ExpectCopies<std::uint32_t>(ScalarType::kUint32, 4294967295U, 16909060);
  ExpectCopies<std::int64_t>(ScalarType::kInt64, -5000000000, 72623859790382856);
  ExpectCopies<std::uint64_t>(ScalarType::kUint64, 18000000000000000000U, 3);
  ExpectCopies<float>(ScalarType::kFloat32, -1.5F, 1e-30F);
  ExpectCopies<double>(ScalarType::kFloat64, 0.1, -1e300);
}

TEST(CopyColumn, MakesInfinityOfWhatDoesNotFitAFloat) {
  const std::vector<double> from{0.25, -1e39, 3.4e38};
  std::vector<float> to(3);
  CopyColumn({ScalarType::kFloat64, reinterpret_cast<const char*>(from.data()), sizeof(double)}, to, 1);
  EXPECT_EQ(to, (std::vector<float>{0.25F, -INFINITY, 3.4e38F}));
}

}  // namespace
}  // namespace ariadne::slam
