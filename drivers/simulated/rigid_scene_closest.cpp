#include <tuple>

#include "drivers/simulated/closest_point.h"
#include "drivers/simulated/rigid_scene.h"

namespace ariadne::drivers {
namespace {

// Embree compares boxes and the query in single precision: what it takes for farther than the nearest
// triangle so far by less than this share of the scene's size may yet be nearer, and is looked at too.
constexpr double kSlack = 1e-6;

/// What is known of the nearest point while Embree walks through its tree.
struct Search {
  std::span<const NumberedMesh> meshes;  // by Embree's geometry id
  Eigen::Vector3d p;
  double slack;  // [m]
  LocalClosest closest;
};

Triangle TriangleOf(const TriangleMesh& mesh, unsigned index) {
  const auto& corners = mesh.triangles[index];
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

/// Of equally near triangles the first counts, in whatever order Embree names them.
bool Nearer(const LocalClosest& a, const LocalClosest& b) {
  return std::tie(a.distance, a.mesh, a.triangle) < std::tie(b.distance, b.mesh, b.triangle);
}

/// Called by Embree for each triangle within the query's radius; true: the radius has shrunk.
bool VisitTriangle(RTCPointQueryFunctionArguments* args) {
  Search& search = *static_cast<Search*>(args->userPtr);
  const NumberedMesh& numbered = search.meshes[args->geomID];
  const Eigen::Vector3d point = ClosestPoint(TriangleOf(*numbered.mesh, args->primID), search.p);
  const LocalClosest candidate{(point - search.p).norm(), point, numbered.number, args->primID};
  if (!Nearer(candidate, search.closest)) return false;
  search.closest = candidate;
  const auto radius = static_cast<float>(candidate.distance + search.slack);
  if (radius >= args->query->radius) return false;
  args->query->radius = radius;
  return true;
}

}  // namespace

LocalClosest RigidScene::Closest(const Eigen::Vector3d& p, double max_distance) const {
  const Eigen::Vector3d local = p - center_;
  Search search{meshes_, p, kSlack * (radius_ + local.norm()), {}};
  search.closest.distance = max_distance;
  RTCPointQuery query;
  query.x = static_cast<float>(local.x());
  query.y = static_cast<float>(local.y());
  query.z = static_cast<float>(local.z());
  query.time = 0.0f;
  query.radius = static_cast<float>(max_distance + search.slack);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_.get(), &query, &context, VisitTriangle, &search);
  if (search.closest.mesh == LocalHit::kNothing) return {};
  return search.closest;
}

}  // namespace ariadne::drivers
