#include "drivers/simulated/ray_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include "drivers/simulated/rigid_scene.h"
#include "drivers/simulated/solids.h"
#include "slam/base/error.h"
#include "slam/geometry/box3.h"

namespace ariadne::drivers {
namespace {

struct Sphere {
  Eigen::Vector3d center;
  double radius;
};

bool Meets(const LocalRay& ray, const Sphere& sphere) {
  const Eigen::Vector3d to_center = sphere.center - ray.origin;
  const double along = std::max(0.0, to_center.dot(ray.direction));
  return (to_center - along * ray.direction).squaredNorm() <= sphere.radius * sphere.radius;
}

/// A body that changes its place, with a scene in its own frame.
struct MovingBody {
  std::uint32_t index;
  RigidScene scene_body;
  Sphere reach_map;  // it never leaves this
};

Sphere ReachOf(const Motion& motion, const RigidScene& scene) {
  slam::Box3 box;
  for (const slam::Pose3& pose : motion.T_map_body) box.extend(pose.translation);
  return {box.center(), 0.5 * box.diagonal().norm() + scene.center().norm() + scene.radius()};
}

void RequireSound(const Body& body) {
  const auto finite = [](const Eigen::Vector3d& v) { return v.allFinite(); };
  if (!std::ranges::all_of(body.mesh_body.vertices, finite)) Fail("{}: a vertex is not finite", body.name);
  for (const auto& triangle : body.mesh_body.triangles) {
    if (std::ranges::max(triangle) < body.mesh_body.vertices.size()) continue;
    Fail("{}: a triangle names vertex {}, but there are {}", body.name, std::ranges::max(triangle),
         body.mesh_body.vertices.size());
  }
  RequireSound(body.motion, body.name);
}

}  // namespace

struct RayScene::Impl {
  explicit Impl(World w);

  /// Looks whether a moving body stands before the hit.
  void CastAtMoving(const Ray& ray, Hit& hit) const;
  Hit ToHit(const LocalHit& local) const;

  World world;
  std::vector<TriangleMesh> placed_map;  // those of standing bodies whose frame is not the map's
  EmbreeDevice device = MakeEmbreeDevice();
  std::unique_ptr<RigidScene> standing_map;
  std::vector<MovingBody> moving;
};

RayScene::Impl::Impl(World w) : world(std::move(w)) {
  placed_map.reserve(world.bodies.size());  // pointers into it are kept
  std::vector<NumberedMesh> standing;
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    RequireSound(body);
    if (body.motion.moves()) {
      RigidScene scene(device, {{i, &body.mesh_body}});
      const Sphere reach = ReachOf(body.motion, scene);
      moving.push_back({i, std::move(scene), reach});
    } else if (body.motion.times.empty()) {
      standing.push_back({i, &body.mesh_body});
    } else {
      placed_map.push_back(Moved(body.mesh_body, PoseAt(body.motion, 0.0)));
      standing.push_back({i, &placed_map.back()});
    }
  }
  standing_map = std::make_unique<RigidScene>(device, std::move(standing));
}

Hit RayScene::Impl::ToHit(const LocalHit& local) const {
  if (local.mesh == LocalHit::kNothing) return {};
  return {local.distance, local.normal, local.mesh, local.triangle,
          world.bodies[local.mesh].material.reflectance};
}

void RayScene::Impl::CastAtMoving(const Ray& ray, Hit& hit) const {
  for (const MovingBody& body : moving) {
    const LocalRay ray_map{ray.origin_map, ray.direction_map};
    if (!Meets(ray_map, body.reach_map)) continue;
    const slam::Pose3 T_map_body = PoseAt(world.bodies[body.index].motion, ray.time);
    const slam::Pose3 T_body_map = T_map_body.Inverse();
    const LocalRay ray_body{T_body_map * ray.origin_map, T_body_map.rotation * ray.direction_map};
    if (!Meets(ray_body, {body.scene_body.center(), body.scene_body.radius()})) continue;
    LocalHit local = body.scene_body.Cast(ray_body);
    if (local.mesh == LocalHit::kNothing || local.distance >= hit.distance) continue;
    local.normal = T_map_body.rotation * local.normal;
    hit = ToHit(local);
  }
}

RayScene::RayScene(World world) : impl_(std::make_unique<Impl>(std::move(world))) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const World& RayScene::world() const { return impl_->world; }

Hit RayScene::Cast(const Ray& ray) const {
  Hit hit;
  Cast(std::span(&ray, 1), std::span(&hit, 1));
  return hit;
}

void RayScene::Cast(std::span<const Ray> rays, std::span<Hit> hits) const {
  if (rays.size() != hits.size()) Fail("{} rays need as many hits, not {}", rays.size(), hits.size());
  std::array<LocalRay, RigidScene::kPacket> packet;
  std::array<LocalHit, RigidScene::kPacket> found;
  for (std::size_t begin = 0; begin < rays.size(); begin += packet.size()) {
    const std::size_t count = std::min(packet.size(), rays.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      packet[i] = {rays[begin + i].origin_map, rays[begin + i].direction_map};
    }
    impl_->standing_map->CastPacket(std::span(packet).first(count), std::span(found).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      hits[begin + i] = impl_->ToHit(found[i]);
      impl_->CastAtMoving(rays[begin + i], hits[begin + i]);
    }
  }
}

}  // namespace ariadne::drivers
