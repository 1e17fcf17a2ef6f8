#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/color.h"

namespace ariadne::experiments {

/// Ink in a pixel: the sums of amount, and of amount times red, green and blue.
using Ink = Eigen::Array4f;

/// A sheet of paper on which ink drops.
class Paper {
 public:
  Paper(int width, int height);

  /// A drop has the shape of a tent; `pen_radius` is 1 to kLargestPen [px]. What falls beside the paper is
  /// lost.
  void Drop(const ImagePoint& point, float amount, Rgb color, double pen_radius);

  /// Row by row from the top.
  const std::vector<Ink>& ink() const { return ink_; }

  static constexpr int kLargestPen = 16;  // [px]

 private:
  int width_, height_;
  std::vector<Ink> ink_;
};

}  // namespace ariadne::experiments
