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

std::vector<LineSegment> FitAll(Points points, std::span<const Piece> pieces,
                                const SplitAndMergeOptions& options) {
  std::vector<LineSegment> lines;
  for (const Piece& piece : pieces) {
    if (piece.size() < static_cast<std::size_t>(options.min_points)) continue;
    std::optional<LineSegment> line = FitSegment(points, piece.first, piece.last, options.noise);
    if (line) lines.push_back(std::move(*line));
  }
  return lines;
}

std::vector<LineSegment> MergeNeighbors(Points points, std::vector<LineSegment> lines,
                                        const SplitAndMergeOptions& options) {
  std::vector<LineSegment> merged;
  for (LineSegment& line : lines) {
    while (!merged.empty()) {
      std::optional<LineSegment> both = Merge(points, merged.back(), line, options);
      if (!both) break;
      line = std::move(*both);
      merged.pop_back();
    }
    merged.push_back(std::move(line));
  }
  return merged;
}

/// Two neighbours, lengthened by the points between them that no line explains: pieces that were too short.
std::pair<LineSegment, LineSegment> WithStrays(Points points, LineSegment a, LineSegment b,
                                               const SplitAndMergeOptions& options) {
  const auto continues = [&](const LineSegment& line, std::size_t end, std::size_t next) {
    return !IsGap(points[end], points[next], options) &&
           Deviation(line, points[next], options.noise) <= options.max_deviation;
  };
  const auto next_of_a = [&] { return a.points.back() + 1; };
  while (next_of_a() < b.points.front() && continues(a, a.points.back(), next_of_a())) {
    a.points.push_back(next_of_a());
  }
  while (b.points.front() > next_of_a() && continues(b, b.points.front(), b.points.front() - 1)) {
    b.points.insert(b.points.begin(), b.points.front() - 1);
  }
  return {std::move(a), std::move(b)};
}

/// The first of the points of two neighbours that is nearer to the second one, if they meet.
std::size_t FindCorner(Points points, const LineSegment& a, const LineSegment& b,
                       const SplitAndMergeOptions& options) {
  std::size_t corner = b.points.front();
  if (a.points.back() + 1 != corner) return corner;
  const auto nearer_to = [&](const LineSegment& line, const LineSegment& other, std::size_t i) {
    const double deviation = Deviation(line, points[i], options.noise);
    return deviation <= options.max_deviation && deviation < Deviation(other, points[i], options.noise);
  };
  while (corner > a.points.front() + 2 && nearer_to(b, a, corner - 1)) --corner;
  if (corner < b.points.front()) return corner;
  while (corner + 2 < b.points.back() && nearer_to(a, b, corner)) ++corner;
  return corner;
}

/// Gives the points between two neighbours to the line that they are nearer to.
void SettleCorner(Points points, LineSegment& a, LineSegment& b, const SplitAndMergeOptions& options) {
  const auto [longer_a, longer_b] = WithStrays(points, a, b, options);
  const std::size_t corner = FindCorner(points, longer_a, longer_b, options);
  std::vector<std::size_t> both = longer_a.points;
  both.insert(both.end(), longer_b.points.begin(), longer_b.points.end());
  const auto of_a = static_cast<std::size_t>(std::ranges::lower_bound(both, corner) - both.begin());
  if (both[of_a - 1] == a.points.back() && corner == b.points.front()) return;
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
  std::vector<LineSegment> lines = FitAll(points, SplitSlice(points, options), options);
  lines = MergeNeighbors(points, std::move(lines), options);
  for (std::size_t i = 1; i < lines.size(); ++i) SettleCorner(points, lines[i - 1], lines[i], options);
  // Again: a piece that had one point from beyond its corner was on no line with its neighbour before.
  lines = MergeNeighbors(points, std::move(lines), options);
  std::erase_if(lines, [&](const LineSegment& line) {
    return line.points.size() < static_cast<std::size_t>(options.min_points);
  });
  return lines;
}

}  // namespace ariadne::slam
