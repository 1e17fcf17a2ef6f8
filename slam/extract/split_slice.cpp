#include "slam/extract/split_slice.h"

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;

double BearingBetween(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  return std::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q)));
}

struct Farthest {
  std::size_t point = 0;
  double deviation = 0.0;  // [sigma]
};

/// How far a point is from the line through `end` along `chord`; from `end` itself where a piece comes back
/// to where it began [sigma].
double DeviationFromChord(const Eigen::Vector2d& p, const Eigen::Vector2d& end,
                          const Eigen::Vector2d& chord, const SliceNoise& noise) {
  const Eigen::Vector2d d = p - end;
  if (chord.isZero(0.0)) return d.norm() / noise.range_sigma;
  const Eigen::Vector2d normal = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
  return std::abs(normal.dot(d)) / SigmaAcross(normal, p, noise);
}

/// The point that is farthest from the chord of a piece.
Farthest FarthestFromChord(Points points, const Piece& piece, const SliceNoise& noise) {
  const Eigen::Vector2d& end = points[piece.first];
  const Eigen::Vector2d chord = points[piece.last] - end;
  Farthest farthest;
  for (std::size_t i = piece.first + 1; i < piece.last; ++i) {
    const double deviation = DeviationFromChord(points[i], end, chord, noise);
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

}  // namespace

bool IsGap(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const SplitAndMergeOptions& options) {
  const double noise = 3.0 * options.noise.range_sigma;
  const double bearing = BearingBetween(p, q);
  const double distance = (q - p).norm();
  if (bearing >= options.grazing_angle) return distance > noise;
  const double nearest = std::min(p.norm(), q.norm());
  return distance > noise + nearest * std::sin(bearing) / std::sin(options.grazing_angle - bearing);
}

std::vector<Piece> SplitSlice(Points points, const SplitAndMergeOptions& options) {
  std::vector<Piece> parts;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    while (last + 1 < points.size() && !IsGap(points[last], points[last + 1], options)) ++last;
    Split(points, {first, last}, options, parts);
    first = last + 1;
  }
  return parts;
}

}  // namespace ariadne::slam
