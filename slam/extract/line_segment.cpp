#include "slam/extract/line_segment.h"

#include "slam/base/error.h"

namespace ariadne::slam {

std::vector<Eigen::Vector2d> EdgePoints(std::span<const LineSegment> segments) {
  std::vector<Eigen::Vector2d> ends;
  ends.reserve(2 * segments.size());
  for (const LineSegment& segment : segments) {
    ends.push_back(segment.from);
    ends.push_back(segment.to);
  }
  return ends;
}

void RequireFinite(std::span<const Eigen::Vector2d> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) continue;
    Fail("point {} of the slice is ({}, {}), which is no place; leave out beams without a return", i,
         points[i].x(), points[i].y());
  }
}

}  // namespace ariadne::slam
