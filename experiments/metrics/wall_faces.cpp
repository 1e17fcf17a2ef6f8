#include "experiments/metrics/wall_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "experiments/metrics/edge_neighbors.h"

namespace ariadne::experiments {
namespace {

using drivers::TriangleMesh;

constexpr std::size_t kWallPointsPerChunk = 4096;

/// A mesh with what growing faces over it needs.
struct Neighborhood {
  std::vector<slam::Plane3> planes;                        // per triangle
  std::vector<double> areas;                               // [m^2]
  std::vector<std::vector<std::uint32_t>> neighbors;       // triangles that share an edge
  std::vector<std::array<Eigen::Vector3d, 3>> corners_of;  // per triangle
};

Neighborhood Prepare(const TriangleMesh& mesh, double weld) {
  Neighborhood n;
  n.neighbors = FindEdgeNeighbors(mesh, weld);
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                          &c = mesh.vertices[triangle[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    n.corners_of.push_back({a, b, c});
    n.areas.push_back(0.5 * normal.norm());
    n.planes.push_back({normal.normalized(), normal.normalized().dot(a)});
  }
  return n;
}

/// Normals may point either way: many meshes do not know their outside.
bool LiesIn(const slam::Plane3& plane, const Neighborhood& n, std::uint32_t t,
            const WallFaceOptions& options) {
  if (n.areas[t] == 0.0) return false;
  if (std::abs(plane.normal.dot(n.planes[t].normal)) < std::cos(options.max_angle)) return false;
  return std::ranges::all_of(n.corners_of[t], [&](const Eigen::Vector3d& corner) {
    return std::abs(plane.Distance(corner)) <= options.max_offset;
  });
}

/// The triangles that can be reached from `seed` within its plane and are not taken yet.
std::vector<std::uint32_t> Grow(std::uint32_t seed, const Neighborhood& n, std::vector<char>& taken,
                                const WallFaceOptions& options) {
  std::vector<std::uint32_t> members{seed};
  taken[seed] = 1;
  for (std::size_t next = 0; next < members.size(); ++next) {
    for (const std::uint32_t t : n.neighbors[members[next]]) {
      if (taken[t] || !LiesIn(n.planes[seed], n, t, options)) continue;
      taken[t] = 1;
      members.push_back(t);
    }
  }
  return members;
}

/// Of the plane from the vertical. [rad]
double Tilt(const slam::Plane3& plane) { return std::asin(std::min(1.0, std::abs(plane.normal.z()))); }

/// Adds the faces of one mesh; returns the face of each of its triangles.
std::vector<std::uint32_t> AddFaces(const TriangleMesh& mesh, const WallFaceOptions& options,
                                    std::vector<WallFace>& faces) {
  const Neighborhood n = Prepare(mesh, options.weld);
  std::vector<std::uint32_t> largest_first(mesh.triangles.size());
  std::iota(largest_first.begin(), largest_first.end(), 0u);
  std::ranges::stable_sort(largest_first, std::greater(), [&](std::uint32_t t) { return n.areas[t]; });
  std::vector<char> taken(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> face_of(mesh.triangles.size(), kNoWall);
  for (const std::uint32_t seed : largest_first) {
    if (taken[seed] || n.areas[seed] == 0.0) continue;
    const std::vector<std::uint32_t> members = Grow(seed, n, taken, options);
    double area = 0.0;
    for (const std::uint32_t t : members) area += n.areas[t];
    if (area < options.min_area || Tilt(n.planes[seed]) > options.max_tilt) continue;
    for (const std::uint32_t t : members) face_of[t] = static_cast<std::uint32_t>(faces.size());
    faces.push_back({n.planes[seed], area});
  }
  return face_of;
}

}  // namespace

WallFaces FindWallFaces(const drivers::World& world, const WallFaceOptions& options) {
  WallFaces walls;
  for (const drivers::Body& body : world.bodies) {
    if (body.motion.moves()) {
      walls.face_of.emplace_back(body.mesh_body.triangles.size(), kNoWall);
    } else {
      walls.face_of.push_back(AddFaces(drivers::MeshAt(body, 0.0), options, walls.faces));
    }
  }
  return walls;
}

std::vector<std::uint32_t> AssignToWalls(const std::vector<Eigen::Vector3d>& points_world,
                                         const WallFaces& walls, const drivers::SurfaceDistance& surface,
                                         double gate, const Parallel& parallel) {
  std::vector<std::uint32_t> assigned(points_world.size(), kNoWall);
  parallel.For(points_world.size(), kWallPointsPerChunk,
               [&](std::size_t begin, std::size_t end, std::size_t) {
                 for (std::size_t k = begin; k < end; ++k) {
                   const drivers::ClosestSurface closest = surface.Closest(points_world[k], gate);
                   if (closest.found()) assigned[k] = walls.face_of[closest.body][closest.triangle];
                 }
               });
  return assigned;
}

}  // namespace ariadne::experiments
