#include "experiments/metrics/wall_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace ariadne::experiments {
namespace {

using drivers::TriangleMesh;

constexpr std::size_t kChunk = 4096;

/// A mesh with what growing faces over it needs.
struct Neighborhood {
  std::vector<slam::Plane3> planes;                        // per triangle
  std::vector<double> areas;                               // [m^2]
  std::vector<std::vector<std::uint32_t>> neighbors;       // triangles that share an edge
  std::vector<std::array<Eigen::Vector3d, 3>> corners_of;  // per triangle
};

/// For each vertex the first one in its cell of a grid: vertices that are one, but for rare neighbours on
/// both sides of a cell's border, which cost a face an edge and no more.
std::vector<std::uint32_t> Weld(const std::vector<Eigen::Vector3d>& vertices, double cell) {
  std::map<std::array<std::int64_t, 3>, std::uint32_t> first_in;
  std::vector<std::uint32_t> welded;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::array<std::int64_t, 3> key;
    for (int axis = 0; axis < 3; ++axis) key[axis] = std::llround(vertices[i][axis] / cell);
    welded.push_back(first_in.emplace(key, i).first->second);
  }
  return welded;
}

std::vector<std::vector<std::uint32_t>> FindNeighbors(const TriangleMesh& mesh, double weld) {
  const std::vector<std::uint32_t> welded = Weld(mesh.vertices, weld);
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> triangles_at;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = welded[mesh.triangles[t][k]], to = welded[mesh.triangles[t][(k + 1) % 3]];
      if (from != to) triangles_at[{std::min(from, to), std::max(from, to)}].push_back(t);
    }
  }
  std::vector<std::vector<std::uint32_t>> neighbors(mesh.triangles.size());
  for (const auto& [edge, triangles] : triangles_at) {
    for (const std::uint32_t a : triangles) {
      for (const std::uint32_t b : triangles) {
        if (a != b) neighbors[a].push_back(b);
      }
    }
  }
  return neighbors;
}

Neighborhood Prepare(const TriangleMesh& mesh, double weld) {
  Neighborhood n;
  n.neighbors = FindNeighbors(mesh, weld);
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
  parallel.For(points_world.size(), kChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const drivers::ClosestSurface closest = surface.Closest(points_world[k], gate);
      if (closest.found()) assigned[k] = walls.face_of[closest.body][closest.triangle];
    }
  });
  return assigned;
}

}  // namespace ariadne::experiments
