#include "slam/extract/length_ratio.h"

#include "slam/extract/slice_points.h"

namespace ariadne::slam {
namespace {

/// The last reduced point of the line that begins at `first`.
std::size_t Grow(std::span<const JoinedPoint> reduced, std::size_t first,
                 const LengthRatioOptions& options) {
  double path = 0.0;
  std::size_t last = first;
  for (; last + 1 < reduced.size(); ++last) {
    const double step = (reduced[last + 1].mean - reduced[last].mean).norm();
    if (step > options.max_gap) break;
    path += step;
    const double chord = (reduced[last + 1].mean - reduced[first].mean).norm();
    const auto count = static_cast<int>(last + 2 - first);
    if (count >= 3 && !(chord > LengthRatioThreshold(count, options) * path)) break;
  }
  return last;
}

}  // namespace

double LengthRatioThreshold(int points, const LengthRatioOptions& options) {
  return options.epsilon_many - (options.epsilon_many - options.epsilon_three) * 3.0 / points;
}

std::vector<LineSegment> DetectByLengthRatio(std::span<const Eigen::Vector2d> points,
                                             const LengthRatioOptions& options) {
  CheckOptions(options, "length_ratio.");
  RequireFinite(points);
  const std::vector<JoinedPoint> reduced = JoinNeighbors(points, options.join_distance);
  std::vector<LineSegment> segments;
  for (std::size_t first = 0; first < reduced.size();) {
    const std::size_t last = Grow(reduced, first, options);
    const std::size_t from = reduced[first].first, to = reduced[last].last;
    const bool enough = to - from + 1 >= static_cast<std::size_t>(options.min_points);
    std::optional<LineSegment> segment;
    if (enough) segment = FitSegment(points, from, to, options.noise);
    // A point that begins no line (a stray between two surfaces) is left behind alone: its successor may.
    first = segment ? last + 1 : first + 1;
    if (segment) segments.push_back(std::move(*segment));
  }
  return segments;
}

}  // namespace ariadne::slam
