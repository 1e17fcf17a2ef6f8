#include "slam/extract/split_and_merge.h"

#include <algorithm>
#include <utility>

#include "slam/extract/split_slice.h"

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;

double Deviation(const LineSegment& line, const Eigen::Vector2d& p, const SliceNoise& noise) {
  return std::abs(line.Distance(p)) / SigmaAcross(line.Normal(), p, noise);
}

/// The line through the points of both, where none of them deviates too far.
std::optional<LineSegment> Merge(Points points, const LineSegment& a, const LineSegment& b,
                                 const SplitAndMergeOptions& options) {
  const std::size_t end = a.points.back(), begin = b.points.front();
  if (begin - end - 1 > static_cast<std::size_t>(options.max_strays)) return std::nullopt;
  if (IsGap(points[end], points[begin], options)) return std::nullopt;
  std::vector<std::size_t> both = a.points;
  both.insert(both.end(), b.points.begin(), b.points.end());
  std::optional<LineSegment> line = FitSegment(points, both, options.noise);
  const bool fits = line && std::ranges::all_of(both, [&](std::size_t i) {
                      return Deviation(*line, points[i], options.noise) <= options.max_deviation;
                    });
  return fits ? line : std::nullopt;
}

/// The fits of the pieces with enough points, neighbours on one line merged.
std::vector<LineSegment> FitAndMerge(Points points, std::span<const Piece> pieces, std::size_t min_points,
                                     const SplitAndMergeOptions& options) {
  std::vector<LineSegment> lines;
  for (const Piece& piece : pieces) {
    if (piece.size() < min_points) continue;
    std::optional<LineSegment> line = FitSegment(points, piece.first, piece.last, options.noise);
    while (line && !lines.empty()) {
      std::optional<LineSegment> merged = Merge(points, lines.back(), *line, options);
      if (!merged) break;
      line = std::move(merged);
      lines.pop_back();
    }
    if (line) lines.push_back(std::move(*line));
  }
  return lines;
}

/// The first of the points of two lines that meet which is nearer to the second line.
std::size_t FindCorner(Points points, const LineSegment& a, const LineSegment& b,
                       const SplitAndMergeOptions& options) {
  const auto nearer_to = [&](const LineSegment& line, const LineSegment& other, std::size_t i) {
    const double deviation = Deviation(line, points[i], options.noise);
    return deviation <= options.max_deviation && deviation < Deviation(other, points[i], options.noise);
  };
  std::size_t corner = b.points.front();
  while (corner > a.points.front() + 2 && nearer_to(b, a, corner - 1)) --corner;
  if (corner < b.points.front()) return corner;
  while (corner + 2 < b.points.back() && nearer_to(a, b, corner)) ++corner;
  return corner;
}

/// Gives the points at a corner to the line that they are nearer to.
void SettleCorner(Points points, LineSegment& a, LineSegment& b, const SplitAndMergeOptions& options) {
  if (a.points.back() + 1 != b.points.front()) return;
  const std::size_t corner = FindCorner(points, a, b, options);
  if (corner == b.points.front()) return;
  std::vector<std::size_t> both = a.points;
  both.insert(both.end(), b.points.begin(), b.points.end());
  const auto of_a = static_cast<std::size_t>(std::ranges::lower_bound(both, corner) - both.begin());
  std::optional<LineSegment> new_a = FitSegment(points, std::span(both).first(of_a), options.noise);
  std::optional<LineSegment> new_b = FitSegment(points, std::span(both).subspan(of_a), options.noise);
  if (!new_a || !new_b) return;
  a = std::move(*new_a);
  b = std::move(*new_b);
}

}  // namespace

std::vector<LineSegment> DetectBySplitAndMerge(Points points, const SplitAndMergeOptions& options) {
  CheckOptions(options, "split_and_merge.");
  RequireFinite(points);
  const auto min_points = static_cast<std::size_t>(options.min_points);
  std::vector<LineSegment> lines = FitAndMerge(points, SplitSlice(points, options), min_points, options);
  for (std::size_t i = 1; i < lines.size(); ++i) SettleCorner(points, lines[i - 1], lines[i], options);
  std::erase_if(lines, [&](const LineSegment& line) { return line.points.size() < min_points; });
  return lines;
}

}  // namespace ariadne::slam
