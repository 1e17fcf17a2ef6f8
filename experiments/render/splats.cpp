#include "experiments/render/splats.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/disc_radii.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

bool Touches(const Camera& camera, const ImagePoint& point, double radius) {
  return point.u > -radius && point.u < camera.width + radius && point.v > -radius &&
         point.v < camera.height + radius;
}

}  // namespace

std::vector<Splat> ProjectSplats(const ColoredPoints& points, const Camera& camera,
                                 const SplatOptions& options) {
  RequireDrawable(points);
  if (options.min_radius > options.max_radius) {
    Fail("points of a view: min_radius {} px is above max_radius {} px", options.min_radius,
         options.max_radius);
  }
  const Projector project(camera);
  std::vector<float> radii;  // [m]
  if (options.radius == 0.0) radii = DiscRadii(points.positions_map);
  std::vector<Splat> splats;
  splats.reserve(points.positions_map.size());
  for (std::size_t i = 0; i < points.positions_map.size(); ++i) {
    const ImagePoint point = project(points.positions_map[i]);
    if (!project.InFront(point.depth)) continue;
    const double radius_map = radii.empty() ? options.radius : static_cast<double>(radii[i]);
    const double radius = std::clamp(radius_map * project.PixelsPerMetre(point.depth), options.min_radius,
                                     options.max_radius);
    if (!Touches(camera, point, radius)) continue;
    const double grain = radius / project.PixelsPerMetre(point.depth) + options.noise;
    splats.push_back({static_cast<float>(point.u), static_cast<float>(point.v),
                      static_cast<float>(point.depth), static_cast<float>(radius),
                      static_cast<float>(grain), points.colors[i]});
  }
  return splats;
}

}  // namespace ariadne::experiments
