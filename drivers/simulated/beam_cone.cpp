#include "drivers/simulated/beam_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ariadne::drivers {
namespace {

constexpr double kCentreWeight = 0.25;

/// The weakest light that is an echo: that of the reference surface at the reference range.
double DetectionThreshold(const RangeFinderOptions& options) {
  if (!options.limit_by_reflectance) return 0.0;
  return options.reference_reflectance / (options.reference_range * options.reference_range);
}

Echo MeanOf(std::span<const RayReturn> returns) {
  Echo echo;
  double sum = 0.0;
  for (const RayReturn& r : returns) {
    echo.light += r.light();
    sum += r.light() * (r.distance - returns.front().distance);
  }
  // Relative to the first, so that equal distances give exactly that distance. A surface seen edge-on sends
  // nothing back, and has no mean.
  echo.distance = returns.front().distance + (echo.light > 0.0 ? sum / echo.light : 0.0);
  return echo;
}

}  // namespace

BeamCone::BeamCone(const RangeFinderOptions& options) : weights_{1.0} {
  if (!options.mixed_pixels) return;
  const double radius = 0.5 * options.divergence * std::sqrt(2.0 / 3.0);
  weights_ = {kCentreWeight};
  for (int i = 0; i < options.rim_rays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / options.rim_rays;
    rim_.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    weights_.push_back((1.0 - kCentreWeight) / options.rim_rays);
  }
}

void BeamCone::AppendRays(const Ray& beam, double turn, std::vector<Ray>& rays) const {
  rays.push_back(beam);
  if (rim_.empty()) return;
  const Eigen::Vector3d across = beam.direction_map.unitOrthogonal();
  const Eigen::Vector3d other = beam.direction_map.cross(across);
  const Eigen::Vector3d u = std::cos(turn) * across + std::sin(turn) * other;
  const Eigen::Vector3d v = beam.direction_map.cross(u);
  for (const Eigen::Vector2d& offset : rim_) {
    const Eigen::Vector3d direction = beam.direction_map + offset.x() * u + offset.y() * v;
    rays.push_back({beam.origin_map, direction.normalized(), beam.time});
  }
}

std::optional<Echo> ChooseEcho(std::span<RayReturn> returns, const RangeFinderOptions& options) {
  std::sort(returns.begin(), returns.end(),
            [](const RayReturn& a, const RayReturn& b) { return a.distance < b.distance; });
  const double threshold = DetectionThreshold(options);
  std::optional<Echo> chosen;
  for (std::size_t begin = 0; begin < returns.size();) {
    std::size_t end = begin + 1;
    while (end < returns.size() &&
           returns[end].distance - returns[begin].distance <= options.pulse_length) {
      ++end;
    }
    const Echo echo = MeanOf(returns.subspan(begin, end - begin));
    begin = end;
    if (echo.light < threshold || (chosen && echo.light <= chosen->light)) continue;
    chosen = echo;
    if (options.echo == EchoChoice::kFirst) break;
  }
  return chosen;
}

}  // namespace ariadne::drivers
