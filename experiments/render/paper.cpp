#include "experiments/render/paper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::experiments {
namespace {

/// The pixels that a drop wets along one axis, and what share of it each gets.
struct Wetted {
  int first = 0;
  int count = 0;
  std::array<float, 2 * Paper::kLargestPen + 1> shares{};
};

/// A tent of the given radius around `position` [px], sampled at the centres of the pixels; shares sum
/// to 1.
Wetted WettedBy(double position, double radius) {
  Wetted wetted;
  wetted.first = static_cast<int>(std::floor(position - 0.5 - radius)) + 1;
  const int end = static_cast<int>(std::ceil(position - 0.5 + radius));
  double sum = 0.0;
  for (int pixel = wetted.first; pixel < end; ++pixel) {
    const double height = radius - std::abs(pixel + 0.5 - position);
    wetted.shares[static_cast<std::size_t>(wetted.count++)] = static_cast<float>(height);
    sum += height;
  }
  for (int i = 0; i < wetted.count; ++i) {
    wetted.shares[static_cast<std::size_t>(i)] /= static_cast<float>(sum);
  }
  return wetted;
}

}  // namespace

Paper::Paper(int width, int height)
    : width_(width),
      height_(height),
      ink_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Ink::Zero()) {}

void Paper::Drop(const ImagePoint& point, float amount, Rgb color, double pen_radius) {
  const auto reaches = [pen_radius](double position, int size) {
    return position > -pen_radius - 1.0 && position < size + pen_radius + 1.0;  // false for NaN
  };
  if (!reaches(point.u, width_) || !reaches(point.v, height_)) return;
  const Ink ink = amount * Ink(1.0F, color.r, color.g, color.b);
  const Wetted columns = WettedBy(point.u, pen_radius);
  const Wetted rows = WettedBy(point.v, pen_radius);
  for (int i = std::max(0, -rows.first); i < rows.count && rows.first + i < height_; ++i) {
    const Ink row_ink = ink * rows.shares[static_cast<std::size_t>(i)];
    const auto row_begin = static_cast<std::size_t>(rows.first + i) * static_cast<std::size_t>(width_);
    for (int j = std::max(0, -columns.first); j < columns.count && columns.first + j < width_; ++j) {
      ink_[row_begin + static_cast<std::size_t>(columns.first + j)] +=
          row_ink * columns.shares[static_cast<std::size_t>(j)];
    }
  }
}

}  // namespace ariadne::experiments
