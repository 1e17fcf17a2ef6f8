#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ariadne::drivers {

/// How the numbers of a list are written. Scanners measure in whole millimetres or centimetres, and
/// reflectance in 256 or 8 levels: as differences between neighbours these take a byte instead of four.
enum class FloatCoding : std::uint8_t {
  kFloats,       // f32
  kMillimeters,  // k of k * 0.001, the product in double and then rounded
  kCentimeters,  // k of k * 0.01
  kBytes,        // k of k / 255.0
  kOctal         // k of k / 7.0
};

struct PackedFloats {
  FloatCoding coding = FloatCoding::kFloats;
  std::string bytes;
};

/// The first coding but kFloats that gives each number back bit by bit, else kFloats. A number takes one
/// LEB128 integer: 0 for LaserSweep::kNoReturn, else 1 + the zigzag code (0, -1, 1, -2, ... as 0, 1, 2, 3,
/// ...) of the difference of its k to that of the last one (at first 0) that was not kNoReturn.
PackedFloats PackFloats(std::span<const float> numbers);

/// Unpacks one number for each of `numbers` from the beginning of `bytes`, and returns how many bytes they
/// took; nothing where the bytes are not those of so many numbers.
std::optional<std::size_t> UnpackFloats(FloatCoding coding, std::string_view bytes,
                                        std::span<float> numbers);

}  // namespace ariadne::drivers
