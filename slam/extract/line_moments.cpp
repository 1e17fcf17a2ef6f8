#include "slam/extract/line_moments.h"

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

Eigen::Vector2d LeftOf(const Eigen::Vector2d& normal) { return {-normal.y(), normal.x()}; }

/// sigma^2 as a factor on the weights' own: what is seen, drawn towards 1 by the prior.
double NoiseScale(double weighted_squares, std::size_t count, const SliceNoise& noise) {
  const double freedom = static_cast<double>(count) - 2.0;
  const double trust = noise.prior_points + freedom;
  return trust > 0.0 ? (noise.prior_points + weighted_squares) / trust : 1.0;
}

/// Independent errors. Angle and offset are independent at the mean of the points, `lever` along the line
/// from the foot of the normal; turning the line about the mean moves the foot.
Eigen::Matrix2d ScatterCovariance(const LineMoments& moments, std::size_t count, const SliceNoise& noise) {
  const Eigen::Vector2d normal = moments.Normal(), tangent = LeftOf(normal);
  const double scale = NoiseScale(normal.dot(moments.scatter * normal), count, noise);
  const double angle = scale / tangent.dot(moments.scatter * tangent);
  const double lever = tangent.dot(moments.mean);
  Eigen::Matrix2d covariance;
  covariance << angle, angle * lever, angle * lever, scale / moments.weight + angle * lever * lever;
  return covariance;
}

/// How (angle, offset) change when each range is longer by `longer(range)`.
Eigen::Vector2d Response(const WeightedPoints& weighted, const LineMoments& moments, const auto& longer) {
  const Eigen::Vector2d normal = moments.Normal(), tangent = LeftOf(normal);
  double shift = 0.0, turn = 0.0;
  for (std::size_t k = 0; k < weighted.indices.size(); ++k) {
    const Eigen::Vector2d& p = weighted.points[weighted.indices[k]];
    const double range = p.norm();
    if (range == 0.0) continue;
    const double across = weighted.weights[k] * normal.dot(p) / range * longer(range);
    shift += across;
    turn -= across * tangent.dot(p - moments.mean);
  }
  const double angle = turn / tangent.dot(moments.scatter * tangent);
  return {angle, shift / moments.weight + angle * tangent.dot(moments.mean)};
}

/// Shared errors: all ranges too long alike, and the near ones by more than the far ones.
Eigen::Matrix2d SystematicCovariance(const WeightedPoints& weighted, const LineMoments& moments,
                                     const SliceNoise& noise) {
  const double middle = moments.mean.norm();
  const Eigen::Vector2d alike = Response(weighted, moments, [](double) { return 1.0; });
  const Eigen::Vector2d sloped = Response(weighted, moments, [&](double range) {
    return std::clamp((range - middle) / noise.systematic_length, -1.0, 1.0);
  });
  const double variance = noise.systematic_sigma * noise.systematic_sigma;
  return variance * (alike * alike.transpose() + sloped * sloped.transpose());
}

}  // namespace

Eigen::Vector2d LineMoments::Normal() const {
  const double along = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  const Eigen::Vector2d normal(-std::sin(along), std::cos(along));
  return normal.dot(mean) < 0.0 ? Eigen::Vector2d(-normal) : normal;
}

LineMoments Gather(const WeightedPoints& weighted) {
  LineMoments moments;
  for (std::size_t k = 0; k < weighted.indices.size(); ++k) {
    moments.weight += weighted.weights[k];
    moments.mean += weighted.weights[k] * weighted.points[weighted.indices[k]];
  }
  moments.mean /= moments.weight;
  for (std::size_t k = 0; k < weighted.indices.size(); ++k) {
    const Eigen::Vector2d d = weighted.points[weighted.indices[k]] - moments.mean;
    moments.scatter += weighted.weights[k] * d * d.transpose();
  }
  return moments;
}

Eigen::Matrix2d LineCovariance(const WeightedPoints& weighted, const LineMoments& moments,
                               const SliceNoise& noise) {
  Eigen::Matrix2d covariance = ScatterCovariance(moments, weighted.indices.size(), noise);
  if (noise.systematic_sigma > 0.0) covariance += SystematicCovariance(weighted, moments, noise);
  return covariance;
}

}  // namespace ariadne::slam
