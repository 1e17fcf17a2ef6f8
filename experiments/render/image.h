#pragma once

#include <cstddef>
#include <vector>

#include "experiments/render/color.h"

namespace ariadne::experiments {

/// A picture. x counts columns to the right and y rows downwards; pixel (x, y) covers [x, x+1) x [y, y+1),
/// so its centre is at (x + 0.5, y + 0.5).
struct Image {
  int width = 0;            // [px]
  int height = 0;           // [px]
  std::vector<Rgb> pixels;  // row by row from the top

  Image() = default;
  /// A picture of one colour; each side is 1 to 32768 px long.
  Image(int width_px, int height_px, Rgb background = kWhite);

  bool Contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  /// Where pixel (x, y), which the picture contains, stands in `pixels`.
  std::size_t IndexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  /// The pixel; an Error where there is none.
  Rgb& At(int x, int y);
  const Rgb& At(int x, int y) const;

  friend bool operator==(const Image&, const Image&) = default;
};

/// Copies `part` onto the canvas, its upper left corner to (x, y); what falls outside is dropped.
void Paste(Image& canvas, const Image& part, int x, int y);

/// The part of a picture whose upper left corner is (x, y); it must lie inside.
Image Cropped(const Image& image, int x, int y, int width, int height);

/// The picture made smaller by a whole number: each pixel is the mean of a block of factor x factor.
/// Both sides must be multiples of the factor.
Image Reduced(const Image& image, int factor);

}  // namespace ariadne::experiments
