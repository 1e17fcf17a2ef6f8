#include "slam/extract/detect_lines.h"

namespace ariadne::slam {

std::vector<LineSegment> DetectLines(std::span<const Eigen::Vector2d> points, const LineOptions& options) {
  switch (options.method) {
    case LineMethod::kLengthRatio:
      return DetectByLengthRatio(points, options.length_ratio);
    case LineMethod::kHough:
      return DetectByHough(points, options.hough);
    case LineMethod::kSplitAndMerge:
      return DetectBySplitAndMerge(points, options.split_and_merge);
  }
  return {};
}

}  // namespace ariadne::slam
