#include "slam/extract/split_and_merge.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;

double BearingBetween(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  return std::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q)));
}

/// Whether the surface ends between two points: one that is met at the grazing angle would, by the law of
/// sines, put them no farther apart than this.
bool IsGap(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const SplitAndMergeOptions& options) {
  const double noise = 3.0 * options.noise.range_sigma;
  const double bearing = BearingBetween(p, q);
  const double distance = (q - p).norm();
  if (bearing >= options.grazing_angle) return distance > noise;
  const double nearest = std::min(p.norm(), q.norm());
  return distance > noise + nearest * std::sin(bearing) / std::sin(options.grazing_angle - bearing);
}

/// Consecutive points, `last` included.
struct Piece {
  std::size_t first = 0;
  std::size_t last = 0;

  std::size_t size() const { return last - first + 1; }
};

struct Farthest {
  std::size_t point = 0;
  double deviation = 0.0;  // [sigma]
};

/// The point that is farthest from the chord of a piece.
Farthest FarthestFromChord(Points points, const Piece& piece, const SliceNoise& noise) {
  const Eigen::Vector2d chord = points[piece.last] - points[piece.first];
  Farthest farthest;
  if (chord.isZero(0.0)) return farthest;
  const Eigen::Vector2d normal = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
  for (std::size_t i = piece.first + 1; i < piece.last; ++i) {
    const double distance = std::abs(normal.dot(points[i] - points[piece.first]));
    const double deviation = distance / SigmaAcross(normal, points[i], noise);
    if (deviation > farthest.deviation) farthest = {i, deviation};
  }
  return farthest;
}

/// Appends the parts of a piece that stay near their chords, in order.
void Split(Points points, Piece piece, const SplitAndMergeOptions& options, std::vector<Piece>& parts) {
  std::vector<Piece> waiting{piece};
  while (!waiting.empty()) {
    piece = waiting.back();
    waiting.pop_back();
    const Farthest farthest = FarthestFromChord(points, piece, options.noise);
    if (farthest.deviation <= options.max_deviation) {
      parts.push_back(piece);
      continue;
    }
    waiting.push_back({farthest.point + 1, piece.last});
    waiting.push_back({piece.first, farthest.point});
  }
}

std::vector<Piece> SplitAll(Points points, const SplitAndMergeOptions& options) {
  std::vector<Piece> parts;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    while (last + 1 < points.size() && !IsGap(points[last], points[last + 1], options)) ++last;
    Split(points, {first, last}, options, parts);
    first = last + 1;
  }
  return parts;
}

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

/// Gives the points at a corner to the line that they are nearer to.
void SettleCorner(Points points, LineSegment& a, LineSegment& b, const SplitAndMergeOptions& options) {
  if (a.points.back() + 1 != b.points.front()) return;
  const auto nearer_to = [&](const LineSegment& line, const LineSegment& other, std::size_t i) {
    return Deviation(line, points[i], options.noise) < Deviation(other, points[i], options.noise) &&
           Deviation(line, points[i], options.noise) <= options.max_deviation;
  };
  const std::size_t corner = b.points.front();
  std::size_t first_of_b = corner;
  while (first_of_b > a.points.front() + 2 && nearer_to(b, a, first_of_b - 1)) --first_of_b;
  if (first_of_b == corner) {
    while (first_of_b + 2 < b.points.back() && nearer_to(a, b, first_of_b)) ++first_of_b;
  }
  if (first_of_b == corner) return;
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  const auto middle = std::ranges::lower_bound(a.points, first_of_b);
  b.points.assign(middle, a.points.end());
  a.points.erase(middle, a.points.end());
  std::optional<LineSegment> new_a = FitSegment(points, a.points, options.noise);
  std::optional<LineSegment> new_b = FitSegment(points, b.points, options.noise);
  if (new_a) a = std::move(*new_a);
  if (new_b) b = std::move(*new_b);
}

}  // namespace

std::vector<LineSegment> DetectBySplitAndMerge(Points points, const SplitAndMergeOptions& options) {
  CheckOptions(options, "split_and_merge.");
  RequireFinite(points);
  const auto min_points = static_cast<std::size_t>(options.min_points);
  std::vector<LineSegment> lines = FitAndMerge(points, SplitAll(points, options), min_points, options);
  for (std::size_t i = 1; i < lines.size(); ++i) SettleCorner(points, lines[i - 1], lines[i], options);
  std::erase_if(lines, [&](const LineSegment& line) { return line.points.size() < min_points; });
  return lines;
}

}  // namespace ariadne::slam
