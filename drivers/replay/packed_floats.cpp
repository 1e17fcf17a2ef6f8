#include "drivers/replay/packed_floats.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "slam/scan/scan.h"

namespace ariadne::drivers {
namespace {

constexpr std::int64_t kLargestWhole = 1 << 24;
constexpr int kLongestCode = 5;  // [B]: 26 bits, 7 in each

bool SameFloat(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

float FloatOf(FloatCoding coding, std::int64_t whole) {
  const auto k = static_cast<double>(whole);
  if (coding == FloatCoding::kMillimeters) return static_cast<float>(k * 0.001);
  if (coding == FloatCoding::kCentimeters) return static_cast<float>(k * 0.01);
  return static_cast<float>(k / (coding == FloatCoding::kBytes ? 255.0 : 7.0));
}

/// The whole number that gives this one bit by bit, if there is one.
std::optional<std::int64_t> WholeOf(FloatCoding coding, float number) {
  const double units = number / static_cast<double>(FloatOf(coding, 1));
  if (!(std::abs(units) < static_cast<double>(kLargestWhole))) return std::nullopt;  // nor is NaN
  const auto whole = static_cast<std::int64_t>(std::round(units));
  return SameFloat(FloatOf(coding, whole), number) ? std::optional(whole) : std::nullopt;
}

void AppendCode(std::uint64_t code, std::string& bytes) {
  for (; code >= 0x80; code >>= 7) bytes.push_back(static_cast<char>(code | 0x80));
  bytes.push_back(static_cast<char>(code));
}

std::optional<std::uint64_t> TakeCode(std::string_view& bytes) {
  std::uint64_t code = 0;
  for (std::size_t i = 0; i < kLongestCode && i < bytes.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(bytes[i]);
    code |= static_cast<std::uint64_t>(byte & 0x7F) << (7 * i);
    if (byte >= 0x80) continue;
    bytes.remove_prefix(i + 1);
    return code;
  }
  return std::nullopt;
}

std::optional<std::string> Pack(FloatCoding coding, std::span<const float> numbers) {
  std::string bytes;
  std::int64_t last = 0;
  for (const float number : numbers) {
    if (SameFloat(number, slam::LaserSweep::kNoReturn)) {
      AppendCode(0, bytes);
      continue;
    }
    const std::optional<std::int64_t> whole = WholeOf(coding, number);
    if (!whole) return std::nullopt;
    const std::int64_t step = *whole - last;
    AppendCode(1 + static_cast<std::uint64_t>(step < 0 ? -2 * step - 1 : 2 * step), bytes);
    last = *whole;
  }
  return bytes;
}

}  // namespace

PackedFloats PackFloats(std::span<const float> numbers) {
  for (const FloatCoding coding :
       {FloatCoding::kMillimeters, FloatCoding::kCentimeters, FloatCoding::kOctal, FloatCoding::kBytes}) {
    if (auto bytes = Pack(coding, numbers)) return {coding, *std::move(bytes)};
  }
  return {FloatCoding::kFloats,
          std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes())};
}

std::optional<std::size_t> UnpackFloats(FloatCoding coding, std::string_view bytes,
                                        std::span<float> numbers) {
  if (coding > FloatCoding::kOctal) return std::nullopt;
  if (coding == FloatCoding::kFloats) {
    if (bytes.size() < numbers.size_bytes()) return std::nullopt;
    if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size_bytes());
    return numbers.size_bytes();
  }
  std::string_view left = bytes;
  std::int64_t whole = 0;
  for (float& number : numbers) {
    const std::optional<std::uint64_t> code = TakeCode(left);
    if (!code) return std::nullopt;
    number = slam::LaserSweep::kNoReturn;
    if (*code == 0) continue;
    const auto zigzag = static_cast<std::int64_t>(*code - 1);
    whole += zigzag % 2 == 0 ? zigzag / 2 : -(zigzag / 2) - 1;
    number = FloatOf(coding, whole);
  }
  return bytes.size() - left.size();
}

}  // namespace ariadne::drivers
