#include "experiments/metrics/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

constexpr double kMostSamples = 1e8;

/// All standing triangles, and the area up to the end of each.
struct AreaList {
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  std::vector<double> area_to_end;  // ascending [m^2]
};

AreaList ListAreas(const drivers::World& world) {
  AreaList list;
  double area = 0.0;
  for (const drivers::Body& body : world.bodies) {
    if (body.motion.moves()) continue;
    const drivers::TriangleMesh mesh = drivers::MeshAt(body, 0.0);
    for (const auto& [i, j, k] : mesh.triangles) {
      const Eigen::Vector3d &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
      area += 0.5 * (b - a).cross(c - a).norm();
      list.triangles.push_back({a, b, c});
      list.area_to_end.push_back(area);
    }
  }
  return list;
}

/// Uniform in the triangle: a square's point, of which the far half is folded back.
Eigen::Vector3d DrawInTriangle(const std::array<Eigen::Vector3d, 3>& triangle, RandomStream& stream) {
  double u = DrawUniform(stream, 0.0, 1.0), v = DrawUniform(stream, 0.0, 1.0);
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

}  // namespace

SurfaceSamples SampleSurface(const drivers::World& world, double density, std::uint64_t seed) {
  const AreaList list = ListAreas(world);
  SurfaceSamples samples;
  if (list.triangles.empty()) return samples;
  samples.area = list.area_to_end.back();
  const double count = std::round(samples.area * density);
  if (!(count <= kMostSamples)) Fail("{:.0f} m^2 at {} points per m^2 are too many", samples.area, density);
  RandomStream stream = NamedStream(seed, "metrics/surface_samples");
  for (double part = 0.0; part < count; part += 1.0) {
    const double at = samples.area * (part + DrawUniform(stream, 0.0, 1.0)) / count;
    const auto end = std::upper_bound(list.area_to_end.begin(), list.area_to_end.end(), at);
    const auto index = std::min<std::size_t>(static_cast<std::size_t>(end - list.area_to_end.begin()),
                                             list.triangles.size() - 1);
    samples.points_world.push_back(DrawInTriangle(list.triangles[index], stream));
  }
  return samples;
}

}  // namespace ariadne::experiments
