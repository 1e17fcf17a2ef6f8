#include "experiments/render/world_view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "experiments/render/pixel_rays.h"

namespace ariadne::experiments {
namespace {

constexpr double kAmbient = 0.45;  // share of the light that does not come from the camera

/// The part of the ray below the cut; nothing where it never comes there.
std::optional<drivers::Ray> Below(drivers::Ray ray, double cut_height) {
  if (ray.origin_map.z() <= cut_height) return ray;
  if (ray.direction_map.z() >= 0.0) return std::nullopt;
  ray.origin_map += (cut_height - ray.origin_map.z()) / ray.direction_map.z() * ray.direction_map;
  return ray;
}

/// Whether the ray meets a surface from the inside of its body.
bool FromInside(const drivers::World& world, const drivers::Ray& ray, const drivers::Hit& hit) {
  const drivers::Body& body = world.bodies[hit.body];
  const auto& [a, b, c] = body.mesh_body.triangles[hit.triangle];
  const std::vector<Eigen::Vector3d>& corners = body.mesh_body.vertices;
  const Eigen::Vector3d outward_body = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
  return (drivers::PoseAt(body.motion, ray.time).rotation * outward_body).dot(ray.direction_map) > 0.0;
}

/// Whether the ray begins in something solid, which the cut has opened. Asked sideways, not along the ray:
/// walls stand on floors and carry ceilings, and which of two surfaces in one place is met first is left to
/// chance.
bool BeginsInside(const drivers::RayScene& scene, const drivers::Ray& ray) {
  const drivers::Ray sideways{ray.origin_map, Eigen::Vector3d(0.80, 0.59, 0.11).normalized(), ray.time};
  const drivers::Hit hit = scene.Cast(sideways);
  return hit.hit() && FromInside(scene.world(), sideways, hit);
}

Rgb ColorOf(const drivers::RayScene& scene, const drivers::Ray& ray, bool was_cut, const drivers::Hit& hit,
            const WorldViewOptions& options) {
  if (!hit.hit()) return options.background;
  if (was_cut && BeginsInside(scene, ray)) return options.cut;
  const double height = (ray.origin_map + hit.distance * ray.direction_map).z();
  const Rgb color = options.color_by_height ? ColorAt(ColorMap::kShore, options.heights.Share(height))
                                            : ColorAt(ColorMap::kGray, std::sqrt(hit.reflectance));
  const double light = kAmbient + (1.0 - kAmbient) * std::abs(hit.normal_map.dot(ray.direction_map));
  return Mix(kBlack, color, light);
}

void RenderRow(const drivers::RayScene& scene, const PixelRays& rays, const WorldViewOptions& options,
               int y, Image& image) {
  for (int x = 0; x < image.width; ++x) {
    const drivers::Ray whole = rays.Through(x + 0.5, y + 0.5);
    std::optional<drivers::Ray> ray = Below(whole, options.cut_height);
    if (!ray) continue;
    ray->time = options.time;
    const bool was_cut = whole.origin_map != ray->origin_map;
    image.pixels[image.IndexOf(x, y)] = ColorOf(scene, *ray, was_cut, scene.Cast(*ray), options);
  }
}

}  // namespace

Image RenderWorld(const drivers::RayScene& scene, const Camera& camera, const WorldViewOptions& options,
                  const Parallel& parallel) {
  RequireUsable(camera);
  const Camera magnified = Magnified(camera, options.supersampling);
  const PixelRays rays(magnified);
  Image image(magnified.width, magnified.height, options.background);
  parallel.For(static_cast<std::size_t>(image.height), 16,
               [&](std::size_t begin, std::size_t end, std::size_t) {
                 for (std::size_t y = begin; y < end; ++y) {
                   RenderRow(scene, rays, options, static_cast<int>(y), image);
                 }
               });
  return Reduced(image, options.supersampling);
}

}  // namespace ariadne::experiments
