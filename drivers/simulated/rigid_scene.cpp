#include "drivers/simulated/rigid_scene.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam/base/error.h"
#include "slam/geometry/box3.h"

namespace ariadne::drivers {
namespace {

void RequireNoError(RTCDevice device, const char* what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY)
    Fail("{}: the memory does not suffice for the world's triangles", what);
  Fail("{}: Embree reports error {}", what, static_cast<int>(error));
}

void* RequireBuffer(void* buffer) {
  if (buffer == nullptr) Fail("the memory does not suffice for the world's triangles");
  return buffer;
}

/// Not for coherent rays: Embree 3.13 then loses hits of packets whose directions nearly lie in a plane of
/// the axes, some ten in a scan.
RTCIntersectContext MakeContext() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return context;
}

slam::Box3 BoxAround(const std::vector<NumberedMesh>& meshes) {
  slam::Box3 box;
  for (const NumberedMesh& m : meshes) {
    for (const Eigen::Vector3d& v : m.mesh->vertices) box.extend(v);
  }
  return box;
}

}  // namespace

EmbreeDevice MakeEmbreeDevice() {
  // Not "threads=1": Embree would hold the whole process to one thread for as long as the device lives.
  const RTCDevice device = rtcNewDevice("set_affinity=0,start_threads=0");
  if (device == nullptr)
    Fail("Embree does not start: error {}", static_cast<int>(rtcGetDeviceError(nullptr)));
  return {device, rtcReleaseDevice};
}

RigidScene::RigidScene(EmbreeDevice device, std::vector<NumberedMesh> meshes)
    : device_(std::move(device)),
      meshes_(std::move(meshes)),
      scene_(rtcNewScene(device_.get()), rtcReleaseScene) {
  const slam::Box3 box = BoxAround(meshes_);
  if (!box.isEmpty()) center_ = box.center();
  for (const NumberedMesh& m : meshes_) {
    for (const Eigen::Vector3d& v : m.mesh->vertices) radius_ = std::max(radius_, (v - center_).norm());
  }
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
  for (std::uint32_t i = 0; i < meshes_.size(); ++i) Attach(i);
  // Alone in an arena of one, the calling thread builds everything, and builds the same tree on any
  // machine.
  tbb::task_arena(1).execute([&] { rtcCommitScene(scene_.get()); });
  RequireNoError(device_.get(), "preparing the world for rays");
}

void RigidScene::Attach(std::uint32_t geometry) {
  const TriangleMesh& mesh = *meshes_[geometry].mesh;
  if (mesh.triangles.empty()) return;
  const RTCGeometry handle = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(RequireBuffer(rtcSetNewGeometryBuffer(
      handle, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size())));
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(v[axis] - center_[axis]);
  }
  auto* indices = static_cast<std::uint32_t*>(
      RequireBuffer(rtcSetNewGeometryBuffer(handle, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size())));
  for (const auto& triangle : mesh.triangles)
    indices = std::copy(triangle.begin(), triangle.end(), indices);
  rtcCommitGeometry(handle);
  rtcAttachGeometryByID(scene_.get(), handle, geometry);
  rtcReleaseGeometry(handle);
}

LocalHit RigidScene::Refine(const LocalRay& ray, unsigned geometry, unsigned triangle,
                            double embree_distance) const {
  const NumberedMesh& numbered = meshes_[geometry];
  const auto& corners = numbered.mesh->triangles[triangle];
  const Eigen::Vector3d a = numbered.mesh->vertices[corners[0]] - ray.origin;
  const Eigen::Vector3d b = numbered.mesh->vertices[corners[1]] - ray.origin;
  const Eigen::Vector3d c = numbered.mesh->vertices[corners[2]] - ray.origin;
  LocalHit hit{embree_distance, (b - a).cross(c - a).normalized(), numbered.number, triangle};
  const double slope = hit.normal.dot(ray.direction);
  if (slope > 0.0) hit.normal = -hit.normal;
  const double exact = hit.normal.dot(a) / -std::abs(slope);
  // A ray that grazes the plane may leave the triangle by the rounding of single precision, and meet its
  // plane anywhere: where it meets the triangle cannot lie beyond the corners.
  const auto [nearest, farthest] =
      std::minmax({a.dot(ray.direction), b.dot(ray.direction), c.dot(ray.direction)});
  if (std::isfinite(exact)) hit.distance = std::clamp(exact, nearest, farthest);
  hit.distance = std::max(hit.distance, 0.0);
  return hit;
}

LocalHit RigidScene::Cast(const LocalRay& ray) const {
  LocalHit hit;
  CastPacket(std::span(&ray, 1), std::span(&hit, 1));
  return hit;
}

void RigidScene::CastPacket(std::span<const LocalRay> rays, std::span<LocalHit> hits) const {
  alignas(32) int valid[kPacket] = {};
  RTCRayHit8 packet = {};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Vector3d origin = rays[i].origin - center_;
    valid[i] = -1;
    packet.ray.org_x[i] = static_cast<float>(origin.x());
    packet.ray.org_y[i] = static_cast<float>(origin.y());
    packet.ray.org_z[i] = static_cast<float>(origin.z());
    packet.ray.dir_x[i] = static_cast<float>(rays[i].direction.x());
    packet.ray.dir_y[i] = static_cast<float>(rays[i].direction.y());
    packet.ray.dir_z[i] = static_cast<float>(rays[i].direction.z());
    packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet.ray.mask[i] = ~0u;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context = MakeContext();
  rtcIntersect8(valid, scene_.get(), &context, &packet);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID
                  ? LocalHit{}
                  : Refine(rays[i], packet.hit.geomID[i], packet.hit.primID[i], packet.ray.tfar[i]);
  }
}

}  // namespace ariadne::drivers
