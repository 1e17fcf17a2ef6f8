#include "slam/extract/fit_segment.h"

#include <algorithm>
#include <numeric>

#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;
using Indices = std::span<const std::size_t>;

// The weights depend on the line only through the angles at which the beams meet it: it settles at once.
constexpr int kReweightings = 3;

/// Weighted mean and scatter of points.
struct Moments {
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();  // sum of w (p - mean)(p - mean)^T
};

Moments Gather(Points points, Indices indices, std::span<const double> weights) {
  Moments moments;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    moments.weight += weights[k];
    moments.mean += weights[k] * points[indices[k]];
  }
  moments.mean /= moments.weight;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const Eigen::Vector2d d = points[indices[k]] - moments.mean;
    moments.scatter += weights[k] * d * d.transpose();
  }
  return moments;
}

/// Across the direction in which the points scatter most, away from the scanner.
Eigen::Vector2d NormalOf(const Moments& moments) {
  const Eigen::Matrix2d& S = moments.scatter;
  const double along = 0.5 * std::atan2(2.0 * S(0, 1), S(0, 0) - S(1, 1));
  const Eigen::Vector2d normal(-std::sin(along), std::cos(along));
  return normal.dot(moments.mean) < 0.0 ? Eigen::Vector2d(-normal) : normal;
}

/// sigma^2 as a factor on the weights' own: what is seen, drawn towards 1 by the prior.
double NoiseScale(double weighted_squares, std::size_t count, const SliceNoise& noise) {
  const double freedom = static_cast<double>(count) - 2.0;
  const double trust = noise.prior_points + freedom;
  return trust > 0.0 ? (noise.prior_points + weighted_squares) / trust : 1.0;
}

/// Of (angle, offset). They are independent at the mean of the points, `lever` along the line from the foot
/// of the normal; turning the line about the mean moves the foot.
Eigen::Matrix2d CovarianceOf(const Moments& moments, double along, double lever, double scale) {
  const double angle = scale / along;
  const double offset = scale / moments.weight;
  Eigen::Matrix2d covariance;
  covariance << angle, angle * lever, angle * lever, offset + angle * lever * lever;
  return covariance;
}

LineSegment MakeSegment(Points points, Indices indices, const Moments& moments, const SliceNoise& noise) {
  const Eigen::Vector2d normal = NormalOf(moments);
  const Eigen::Vector2d tangent(-normal.y(), normal.x());  // to the scanner's left
  LineSegment segment;
  segment.angle = WrapAngle(std::atan2(normal.y(), normal.x()));
  segment.offset = std::max(0.0, normal.dot(moments.mean));
  segment.points.assign(indices.begin(), indices.end());
  double squares = 0.0, right = 0.0, left = 0.0;
  for (const std::size_t i : indices) {
    const Eigen::Vector2d d = points[i] - moments.mean;
    squares += std::pow(normal.dot(d), 2);
    right = std::min(right, tangent.dot(d));
    left = std::max(left, tangent.dot(d));
  }
  segment.rms = std::sqrt(squares / static_cast<double>(indices.size()));
  segment.from = moments.mean + right * tangent;
  segment.to = moments.mean + left * tangent;
  const double scale = NoiseScale(normal.dot(moments.scatter * normal), indices.size(), noise);
  const double along = tangent.dot(moments.scatter * tangent);
  segment.covariance = CovarianceOf(moments, along, tangent.dot(moments.mean), scale);
  return segment;
}

bool AreOnePlace(Points points, Indices indices) {
  return std::ranges::all_of(indices, [&](std::size_t i) { return points[i] == points[indices.front()]; });
}

}  // namespace

double SigmaAcross(const Eigen::Vector2d& normal, const Eigen::Vector2d& p, const SliceNoise& noise) {
  const double range = p.norm();
  if (range == 0.0) return noise.range_sigma;  // from no direction
  const double ahead = normal.dot(p) / range;
  const double aside = normal.x() * p.y() - normal.y() * p.x();  // range times the sine of incidence
  return std::hypot(noise.range_sigma * ahead, noise.bearing_sigma * aside) + 1e-3 * noise.range_sigma;
}

std::optional<LineSegment> FitSegment(Points points, Indices indices, const SliceNoise& noise) {
  if (indices.empty() || AreOnePlace(points, indices)) return std::nullopt;
  std::vector<double> weights(indices.size(), 1.0);
  Moments moments = Gather(points, indices, weights);
  for (int pass = 0; pass < kReweightings; ++pass) {
    const Eigen::Vector2d normal = NormalOf(moments);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      weights[k] = std::pow(SigmaAcross(normal, points[indices[k]], noise), -2);
    }
    moments = Gather(points, indices, weights);
  }
  return MakeSegment(points, indices, moments, noise);
}

std::optional<LineSegment> FitSegment(Points points, std::size_t first, std::size_t last,
                                      const SliceNoise& noise) {
  std::vector<std::size_t> indices(last - first + 1);
  std::iota(indices.begin(), indices.end(), first);
  return FitSegment(points, indices, noise);
}

}  // namespace ariadne::slam
