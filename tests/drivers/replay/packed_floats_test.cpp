#include "drivers/replay/packed_floats.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "slam/base/random.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {
namespace {

std::vector<std::uint32_t> BitsOf(const std::vector<float>& numbers) {
  std::vector<std::uint32_t> bits;
  for (const float number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(number));
  return bits;
}

/// Packs and unpacks, with other bytes behind, and returns what packed them.
PackedFloats ExpectUnchanged(const std::vector<float>& numbers) {
  const PackedFloats packed = PackFloats(numbers);
  std::vector<float> again(numbers.size());
  const auto taken = UnpackFloats(packed.coding, packed.bytes + "more", again);
  EXPECT_TRUE(taken && *taken == packed.bytes.size());
  EXPECT_EQ(BitsOf(again), BitsOf(numbers));
  return packed;
}

TEST(PackedFloats, TakeAByteForMillimetersOfAWall) {
  RandomStream stream = NamedStream(1, "wall");
  std::vector<float> ranges;
  for (int i = 0; i < 361; ++i) {
    ranges.push_back(static_cast<float>(std::round(3000.0 + DrawNormal(stream, 0.0, 5.0)) * 0.001));
  }
  const PackedFloats packed = ExpectUnchanged(ranges);
  EXPECT_EQ(packed.coding, FloatCoding::kMillimeters);
  EXPECT_LE(packed.bytes.size(), 361U + 1U);
}

TEST(PackedFloats, KnowTheUnitsOfScanners) {
  RandomStream stream = NamedStream(2, "units");
  std::vector<float> meters{slam::LaserSweep::kNoReturn}, bytes = meters, octal = meters;
  for (int i = 0; i < 400; ++i) {
    meters.push_back(static_cast<float>(static_cast<double>(stream() % 81910) * 0.001));
    bytes.push_back(static_cast<float>(static_cast<double>(stream() % 256) / 255.0));
    octal.push_back(static_cast<float>(static_cast<double>(stream() % 8) / 7.0));
  }
  EXPECT_EQ(ExpectUnchanged(meters).coding, FloatCoding::kMillimeters);
  EXPECT_EQ(ExpectUnchanged(bytes).coding, FloatCoding::kBytes);
  EXPECT_EQ(ExpectUnchanged(octal).coding, FloatCoding::kOctal);
}

TEST(PackedFloats, KeepAnyBits) {
  RandomStream stream = NamedStream(3, "bits");
  using Limits = std::numeric_limits<float>;
  for (const float odd : {-0.0F, Limits::infinity(), Limits::denorm_min(), Limits::max(), 1e9F, -2.5F,
                          std::bit_cast<float>(0x7FC00001U), std::bit_cast<float>(0xFFC00000U)}) {
    ExpectUnchanged({1.0F, odd, slam::LaserSweep::kNoReturn, 2.0F});
  }
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<float> numbers(stream() % 4);
    for (float& number : numbers) number = std::bit_cast<float>(static_cast<std::uint32_t>(stream()));
    ExpectUnchanged(numbers);
  }
  ExpectUnchanged({});
  ExpectUnchanged({16777.0F, -16777.0F, 0.0F});
}

TEST(PackedFloats, AreRefusedWhereTheyAreNone) {
  std::vector<float> two(2);
  EXPECT_FALSE(UnpackFloats(FloatCoding::kFloats, "1234567", two));
  EXPECT_FALSE(UnpackFloats(FloatCoding::kMillimeters, std::string("\x05", 1), two));
  EXPECT_FALSE(UnpackFloats(FloatCoding::kMillimeters, "\x81\x81\x81\x81\x81\x01\x01", two)) << "too long";
  EXPECT_FALSE(UnpackFloats(static_cast<FloatCoding>(5), "12345678", two));
  EXPECT_EQ(UnpackFloats(FloatCoding::kMillimeters, "\x05\x05", two), 2U);
}

}  // namespace
}  // namespace ariadne::drivers
