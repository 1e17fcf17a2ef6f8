#include "drivers/simulated/surface_distance.h"

#include <vector>

#include "drivers/simulated/rigid_scene.h"

namespace ariadne::drivers {

struct SurfaceDistance::Impl {
  explicit Impl(const World& world);

  std::vector<TriangleMesh> meshes_map;
  std::unique_ptr<RigidScene> scene;
};

SurfaceDistance::Impl::Impl(const World& world) {
  meshes_map.reserve(world.bodies.size());  // pointers into it are kept
  std::vector<NumberedMesh> numbered;
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].motion.moves()) continue;
    meshes_map.push_back(MeshAt(world.bodies[i], 0.0));
    numbered.push_back({i, &meshes_map.back()});
  }
  scene = std::make_unique<RigidScene>(MakeEmbreeDevice(), std::move(numbered));
}

SurfaceDistance::SurfaceDistance(const World& world) : impl_(std::make_unique<Impl>(world)) {}
SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

ClosestSurface SurfaceDistance::Closest(const Eigen::Vector3d& p_map, double max_distance) const {
  const LocalClosest closest = impl_->scene->Closest(p_map, max_distance);
  return {closest.distance, closest.point, closest.mesh, closest.triangle};
}

}  // namespace ariadne::drivers
