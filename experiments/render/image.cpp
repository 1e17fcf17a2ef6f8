#include "experiments/render/image.h"

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr int kMaxSide = 32768;

void RequireInside(const Image& image, int x, int y) {
  if (!image.Contains(x, y)) {
    Fail("there is no pixel ({}, {}) in a picture of {} x {}", x, y, image.width, image.height);
  }
}

/// The mean of the block of pixels whose upper left one is `first`.
Rgb BlockMean(const Rgb* first, std::size_t row_stride, int factor) {
  int r = 0, g = 0, b = 0;
  for (int row = 0; row < factor; ++row) {
    const Rgb* pixel = first + static_cast<std::size_t>(row) * row_stride;
    for (const Rgb* end = pixel + factor; pixel != end; ++pixel) {
      r += pixel->r;
      g += pixel->g;
      b += pixel->b;
    }
  }
  const int count = factor * factor;
  const auto mean = [count](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
  return {mean(r), mean(g), mean(b)};
}

}  // namespace

Image::Image(int width_px, int height_px, Rgb background) : width(width_px), height(height_px) {
  if (std::min(width, height) < 1 || std::max(width, height) > kMaxSide) {
    Fail("a picture of {} x {} pixels cannot be made: each side must be 1 to {}", width, height, kMaxSide);
  }
  pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background);
}

Rgb& Image::At(int x, int y) {
  RequireInside(*this, x, y);
  return pixels[IndexOf(x, y)];
}

const Rgb& Image::At(int x, int y) const {
  RequireInside(*this, x, y);
  return pixels[IndexOf(x, y)];
}

void Paste(Image& canvas, const Image& part, int x, int y) {
  const int first_column = std::max(0, -x);
  const int end_column = std::min(part.width, canvas.width - x);
  if (first_column >= end_column) return;
  for (int row = std::max(0, -y); row < std::min(part.height, canvas.height - y); ++row) {
    std::copy_n(&part.pixels[part.IndexOf(first_column, row)], end_column - first_column,
                &canvas.pixels[canvas.IndexOf(x + first_column, y + row)]);
  }
}

Image Cropped(const Image& image, int x, int y, int width, int height) {
  Image part(width, height);
  RequireInside(image, x, y);
  RequireInside(image, x + width - 1, y + height - 1);
  Paste(part, image, -x, -y);
  return part;
}

Image Reduced(const Image& image, int factor) {
  if (factor < 1 || image.width % factor != 0 || image.height % factor != 0) {
    Fail("a picture of {} x {} pixels cannot be reduced by {}", image.width, image.height, factor);
  }
  if (factor == 1) return image;
  Image reduced(image.width / factor, image.height / factor);
  const auto row_stride = static_cast<std::size_t>(image.width);
  for (int y = 0; y < reduced.height; ++y) {
    for (int x = 0; x < reduced.width; ++x) {
      const Rgb* first = &image.pixels[image.IndexOf(x * factor, y * factor)];
      reduced.pixels[reduced.IndexOf(x, y)] = BlockMean(first, row_stride, factor);
    }
  }
  return reduced;
}

}  // namespace ariadne::experiments
