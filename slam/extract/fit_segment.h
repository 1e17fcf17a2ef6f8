#pragma once

#include <optional>
#include <span>

#include "slam/extract/line_segment.h"
#include "slam/extract/slice_noise.h"

namespace ariadne::slam {

/// The line of least squared distances through points[indices] (ascending indices), each distance weighed
/// by the noise: total least squares where the beams meet the line alike. The covariance takes
/// the independent noise from its prior and the scatter of the points, and adds what ranges have in common.
/// Nothing where the points are all in one place.
std::optional<LineSegment> FitSegment(std::span<const Eigen::Vector2d> points,
                                      std::span<const std::size_t> indices, const SliceNoise& noise);

/// The same for the points first, ..., last.
std::optional<LineSegment> FitSegment(std::span<const Eigen::Vector2d> points, std::size_t first,
                                      std::size_t last, const SliceNoise& noise);

}  // namespace ariadne::slam
