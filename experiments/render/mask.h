#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "experiments/render/image.h"

namespace ariadne::experiments {

/// How much of each pixel a shape covers, in a rectangle of the canvas. Parts of a shape are united by the
/// larger coverage, so that overlapping parts show no seam; then the whole is painted once.
class Mask {
 public:
  /// The pixels of the canvas that `bounds` [px] touches; possibly none.
  Mask(const Image& canvas, const Eigen::AlignedBox2d& bounds);

  /// Unites with a line of round ends. [px]
  void AddSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width);

  /// Unites with the shape whose signed distance [px], negative inside, is given for a point [px].
  template <typename SignedDistance>
  void AddShape(const Eigen::AlignedBox2d& bounds, const SignedDistance& signed_distance);

  /// Paints the shape on the canvas from which the mask was made.
  void Paint(Image& canvas, Rgb color, double opacity) const;

 private:
  Eigen::AlignedBox2i PixelsIn(const Eigen::AlignedBox2d& bounds) const;
  float& At(int x, int y);

  Eigen::AlignedBox2i pixels_;  // first and last column and row, inclusive
  std::vector<float> coverage_;
};

template <typename SignedDistance>
void Mask::AddShape(const Eigen::AlignedBox2d& bounds, const SignedDistance& signed_distance) {
  const Eigen::AlignedBox2i part = PixelsIn(bounds);
  if (part.isEmpty()) return;
  for (int y = part.min().y(); y <= part.max().y(); ++y) {
    for (int x = part.min().x(); x <= part.max().x(); ++x) {
      // A pixel whose centre lies on the outline is half covered, one half a pixel inside of it fully.
      const double distance = signed_distance(Eigen::Vector2d(x + 0.5, y + 0.5));
      const auto covered = static_cast<float>(std::clamp(0.5 - distance, 0.0, 1.0));
      At(x, y) = std::max(At(x, y), covered);
    }
  }
}

}  // namespace ariadne::experiments
