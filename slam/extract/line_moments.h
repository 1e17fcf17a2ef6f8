#pragma once

#include <span>
#include <vector>

#include "slam/extract/slice_noise.h"

namespace ariadne::slam {

/// Some points of a slice, each with its weight [1/m^2].
struct WeightedPoints {
  std::span<const Eigen::Vector2d> points;
  std::span<const std::size_t> indices;  // of the points that count
  std::vector<double> weights;           // one per index
};

/// Weighted mean and scatter.
struct LineMoments {
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();  // sum of w (p - mean)(p - mean)^T

  /// Across the direction in which the points scatter most, away from the scanner.
  Eigen::Vector2d Normal() const;
};

LineMoments Gather(const WeightedPoints& weighted);

/// Of (angle, offset) of the line through the moments' mean and across their normal, with weights of
/// 1 / SigmaAcross^2: from the noise that the scatter shows, and from the systematic part that it does not.
Eigen::Matrix2d LineCovariance(const WeightedPoints& weighted, const LineMoments& moments,
                               const SliceNoise& noise);

}  // namespace ariadne::slam
