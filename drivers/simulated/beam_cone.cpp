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

std::size_t RaysPerBeam(const RangeFinderOptions& options) {
  return options.mixed_pixels ? 1 + static_cast<std::size_t>(options.rim_rays) : 1;
}

std::vector<double> RayWeights(const RangeFinderOptions& options) {
  if (!options.mixed_pixels) return {1.0};
  std::vector<double> weights(RaysPerBeam(options), (1.0 - kCentreWeight) / options.rim_rays);
  weights.front() = kCentreWeight;
  return weights;
}

void AppendBeamRays(const Ray& beam, double turn, const RangeFinderOptions& options,
                    std::vector<Ray>& rays) {
  rays.push_back(beam);
  if (!options.mixed_pixels) return;
  const double radius = 0.5 * options.divergence * std::sqrt(2.0 / 3.0);
  const Eigen::Vector3d across = beam.direction_map.unitOrthogonal();
  const Eigen::Vector3d other = beam.direction_map.cross(across);
  for (int i = 0; i < options.rim_rays; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / options.rim_rays;
    const Eigen::Vector3d offset = radius * (std::cos(angle) * across + std::sin(angle) * other);
    rays.push_back({beam.origin_map, (beam.direction_map + offset).normalized(), beam.time});
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
