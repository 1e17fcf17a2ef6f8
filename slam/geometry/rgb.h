#pragma once

#include <cstdint>

namespace ariadne::slam {

/// A colour as it stands in pictures and files: sRGB, 8 bits per channel.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

}  // namespace ariadne::slam
