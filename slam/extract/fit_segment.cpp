#include "slam/extract/fit_segment.h"

#include <algorithm>
#include <numeric>

#include "slam/extract/line_moments.h"
#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;
using Indices = std::span<const std::size_t>;

// The weights depend on the line only through the angles at which the beams meet it: it settles at once.
constexpr int kReweightings = 3;
constexpr double kSamePlace = 1e-9;  // nearer points have no direction between them [m]

LineSegment MakeSegment(const WeightedPoints& weighted, const LineMoments& moments,
                        const SliceNoise& noise) {
  const Eigen::Vector2d normal = moments.Normal();
  const Eigen::Vector2d tangent(-normal.y(), normal.x());  // to the scanner's left
  LineSegment segment;
  segment.angle = WrapAngle(std::atan2(normal.y(), normal.x()));
  segment.offset = std::max(0.0, normal.dot(moments.mean));
  segment.covariance = LineCovariance(weighted, moments, noise);
  segment.points.assign(weighted.indices.begin(), weighted.indices.end());
  double squares = 0.0, right = 0.0, left = 0.0;
  for (const std::size_t i : weighted.indices) {
    const Eigen::Vector2d d = weighted.points[i] - moments.mean;
    squares += std::pow(normal.dot(d), 2);
    right = std::min(right, tangent.dot(d));
    left = std::max(left, tangent.dot(d));
  }
  segment.rms = std::sqrt(squares / static_cast<double>(weighted.indices.size()));
  segment.from = moments.mean + right * tangent;
  segment.to = moments.mean + left * tangent;
  return segment;
}

bool AreOnePlace(Points points, Indices indices) {
  return std::ranges::all_of(
      indices, [&](std::size_t i) { return (points[i] - points[indices.front()]).norm() <= kSamePlace; });
}

}  // namespace

std::optional<LineSegment> FitSegment(Points points, Indices indices, const SliceNoise& noise) {
  if (indices.empty() || AreOnePlace(points, indices)) return std::nullopt;
  WeightedPoints weighted{points, indices, std::vector<double>(indices.size(), 1.0)};
  LineMoments moments = Gather(weighted);
  for (int pass = 0; pass < kReweightings; ++pass) {
    const Eigen::Vector2d normal = moments.Normal();
    for (std::size_t k = 0; k < indices.size(); ++k) {
      weighted.weights[k] = std::pow(SigmaAcross(normal, points[indices[k]], noise), -2);
    }
    moments = Gather(weighted);
  }
  return MakeSegment(weighted, moments, noise);
}

std::optional<LineSegment> FitSegment(Points points, std::size_t first, std::size_t last,
                                      const SliceNoise& noise) {
  std::vector<std::size_t> indices(last - first + 1);
  std::iota(indices.begin(), indices.end(), first);
  return FitSegment(points, indices, noise);
}

}  // namespace ariadne::slam
