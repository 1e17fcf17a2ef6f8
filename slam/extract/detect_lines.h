#pragma once

#include "slam/extract/hough_lines.h"
#include "slam/extract/length_ratio.h"
#include "slam/extract/split_and_merge.h"

namespace ariadne::slam {

/// How the points of a slice become lines.
enum class LineMethod {
  kLengthRatio,    // the paper's (Sec. 2.2.1 step 2)
  kHough,          // the group's other detector, also for points without an order
  kSplitAndMerge,  // beside them
};

struct LineOptions {
  LineMethod method = LineMethod::kSplitAndMerge;
  LengthRatioOptions length_ratio;
  HoughOptions hough;
  SplitAndMergeOptions split_and_merge;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method,
          "length_ratio is the paper's (2.2.1), hough needs no order (4.2), split_and_merge is the most "
          "accurate");
    visit("length_ratio", self.length_ratio, "of length_ratio");
    visit("hough", self.hough, "of hough");
    visit("split_and_merge", self.split_and_merge, "of split_and_merge");
  }
};

/// The lines of one slice: points in its plane, the scanner at the origin, in the order of the beams unless
/// the method needs none. Error where a point is not finite or an option is out of its range.
std::vector<LineSegment> DetectLines(std::span<const Eigen::Vector2d> points, const LineOptions& options);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::LineMethod> {
  static constexpr std::array<std::string_view, 3> value{"length_ratio", "hough", "split_and_merge"};
};

}  // namespace ariadne
