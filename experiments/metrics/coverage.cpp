#include "experiments/metrics/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/metrics/surface_samples.h"
#include "slam/base/error.h"
#include "slam/search/kd_tree.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSamplesPerChunk = 64;  // each with up to thousands of rays
constexpr std::size_t kPacket = 32;           // rays at once: the nearest viewpoints mostly decide

/// Whether some viewpoint sees a point.
class Visibility {
 public:
  Visibility(const drivers::RayScene& scene, const std::vector<Vector3d>& viewpoints,
             const VisibleSurfaceOptions& options)
      : scene_(scene),
        viewpoints_(viewpoints),
        o_(options),
        lowest_slope_(std::tan(options.lowest_elevation)),
        highest_slope_(std::tan(options.highest_elevation)) {}

  bool Sees(const Vector3d& p) const {
    const std::vector<std::uint32_t> nearest_first = Candidates(p);
    std::vector<drivers::Ray> rays;
    std::vector<drivers::Hit> hits;
    for (std::size_t begin = 0; begin < nearest_first.size(); begin += kPacket) {
      rays.clear();
      for (std::size_t i = begin; i < std::min(begin + kPacket, nearest_first.size()); ++i) {
        const Vector3d& from = viewpoints_[nearest_first[i]];
        rays.push_back({from, (p - from).normalized(), 0.0});
      }
      hits.resize(rays.size());
      scene_.Cast(rays, hits);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].distance >= (p - rays[i].origin_map).norm() - o_.tolerance) return true;
      }
    }
    return false;
  }

 private:
  /// Those with the point in their range and field of view.
  std::vector<std::uint32_t> Candidates(const Vector3d& p) const {
    std::vector<std::pair<double, std::uint32_t>> near;
    for (std::uint32_t i = 0; i < viewpoints_.size(); ++i) {
      const Vector3d d = p - viewpoints_[i];
      if (d.squaredNorm() > o_.max_range * o_.max_range || d.isZero()) continue;
      const double slope = d.z() / d.head<2>().norm();
      if (slope >= lowest_slope_ && slope <= highest_slope_) near.emplace_back(d.squaredNorm(), i);
    }
    std::sort(near.begin(), near.end());
    std::vector<std::uint32_t> indices;
    for (const auto& [squared_distance, i] : near) indices.push_back(i);
    return indices;
  }

  const drivers::RayScene& scene_;
  const std::vector<Vector3d>& viewpoints_;
  const VisibleSurfaceOptions& o_;
  double lowest_slope_, highest_slope_;
};

}  // namespace

VisibleSurface FindVisibleSurface(const drivers::RayScene& scene,
                                  const std::vector<Vector3d>& viewpoints_world,
                                  const VisibleSurfaceOptions& options, const Parallel& parallel) {
  const SurfaceSamples samples = SampleSurface(scene.world(), options.density, options.seed);
  const Visibility visibility(scene, viewpoints_world, options);
  std::vector<char> visible(samples.points_world.size());
  parallel.For(visible.size(), kSamplesPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) visible[k] = visibility.Sees(samples.points_world[k]) ? 1 : 0;
  });
  VisibleSurface surface;
  for (std::size_t k = 0; k < visible.size(); ++k) {
    if (visible[k]) surface.points_world.push_back(samples.points_world[k]);
  }
  surface.total_area = samples.area;
  if (!visible.empty()) {
    surface.area = samples.area * static_cast<double>(surface.points_world.size()) /
                   static_cast<double>(visible.size());
  }
  return surface;
}

Coverage MeasureCoverage(const std::vector<Vector3d>& points_map, const slam::Pose3& T_world_map,
                         const VisibleSurface& surface, const CoverageOptions& options,
                         const Parallel& parallel) {
  if (surface.points_world.empty()) Fail("no surface is visible: there is nothing to cover");
  if (points_map.empty()) return {};
  const slam::KdTree tree(points_map);
  const slam::Pose3 T_map_world = T_world_map.Inverse();
  const std::size_t count = surface.points_world.size();
  std::vector<char> covered(count);
  parallel.For(count, kSamplesPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vector3d p_map = T_map_world * surface.points_world[k];
      covered[k] = tree.Nearest(p_map, options.radius).index != slam::kNoPoint ? 1 : 0;
    }
  });
  Coverage coverage;
  for (std::size_t k = 0; k < count; ++k) {
    if (!covered[k]) coverage.missed_world.push_back(surface.points_world[k]);
  }
  coverage.covered = count - coverage.missed_world.size();
  coverage.share = static_cast<double>(coverage.covered) / static_cast<double>(count);
  coverage.area = coverage.share * surface.area;
  return coverage;
}

}  // namespace ariadne::experiments
