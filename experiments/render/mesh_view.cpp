#include "experiments/render/mesh_view.h"

#include <cmath>

#include "experiments/render/pixel_rays.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

drivers::World WorldOf(const slam::TriangleMesh& mesh_map) {
  if (mesh_map.triangles.empty()) Fail("there are no triangles to draw");
  drivers::World world;
  world.bodies.push_back({"mesh", mesh_map, {}, {}});
  return world;
}

Rgb MeanColor(const slam::TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Rgb first_two = Mix(mesh.colors[a], mesh.colors[b], 0.5);
  return Mix(first_two, mesh.colors[c], 1.0 / 3.0);
}

}  // namespace

Image RenderMesh(const slam::TriangleMesh& mesh_map, const Camera& camera, const MeshViewOptions& options,
                 const Parallel& parallel) {
  RequireUsable(camera);
  const drivers::RayScene scene(WorldOf(mesh_map));
  const Camera magnified = Magnified(camera, options.supersampling);
  const PixelRays rays(magnified);
  Image image(magnified.width, magnified.height, options.background);
  const auto color_of = [&](const drivers::Ray& ray, const drivers::Hit& hit) {
    const Rgb color = mesh_map.colors.empty() ? options.surface : MeanColor(mesh_map, hit.triangle);
    const double facing = std::abs(hit.normal_map.dot(ray.direction_map));
    return Mix(kBlack, color, options.ambient + (1.0 - options.ambient) * facing);
  };
  parallel.For(static_cast<std::size_t>(image.height), 16,
               [&](std::size_t begin, std::size_t end, std::size_t) {
                 for (std::size_t y = begin; y < end; ++y) {
                   for (int x = 0; x < image.width; ++x) {
                     const drivers::Ray ray = rays.Through(x + 0.5, static_cast<double>(y) + 0.5);
                     const drivers::Hit hit = scene.Cast(ray);
                     if (hit.hit())
                       image.pixels[image.IndexOf(x, static_cast<int>(y))] = color_of(ray, hit);
                   }
                 }
               });
  return Reduced(image, options.supersampling);
}

}  // namespace ariadne::experiments
