#include "slam/extract/slice_noise.h"

#include <cmath>

namespace ariadne::slam {

double SigmaAcross(const Eigen::Vector2d& normal, const Eigen::Vector2d& p, const SliceNoise& noise) {
  const double range = p.norm();
  if (range == 0.0) return noise.range_sigma;  // from no direction
  const double ahead = normal.dot(p) / range;
  const double aside = normal.x() * p.y() - normal.y() * p.x();  // range times the sine of incidence
  return std::hypot(noise.range_sigma * ahead, noise.bearing_sigma * aside) +
         kLeastSigma * noise.range_sigma;
}

}  // namespace ariadne::slam
