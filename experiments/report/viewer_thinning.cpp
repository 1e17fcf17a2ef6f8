#include "experiments/report/viewer_thinning.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace ariadne::experiments {
namespace {

constexpr double kFirstSpacing = 0.01;  // [m]
constexpr double kLastSpacing = 1e6;    // [m]

/// The cube of a point, and what else keeps points apart.
struct CubeKey {
  std::array<std::int64_t, 3> cube{};
  std::uint32_t group = 0;

  friend bool operator==(const CubeKey&, const CubeKey&) = default;
};

struct CubeHash {
  std::size_t operator()(const CubeKey& key) const {
    std::uint64_t hash = key.group;
    for (const std::int64_t c : key.cube) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

CubeKey CubeOf(const Eigen::Vector3d& p_map, std::uint32_t group, double spacing) {
  CubeKey key{{}, group};
  for (int axis = 0; axis < 3; ++axis)
    key.cube[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(p_map[axis] / spacing));
  return key;
}

/// Points lie on surfaces, so their number falls with the square of the spacing.
double NextSpacing(double spacing, std::size_t count, std::size_t max_count) {
  const double ratio =
      static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, max_count));
  return spacing * std::clamp(std::sqrt(ratio), 1.1, 4.0);
}

std::vector<ViewerPoint> FirstOfEachCube(const std::vector<ViewerPoint>& points, double spacing) {
  std::unordered_set<CubeKey, CubeHash> taken;
  taken.reserve(points.size());
  std::vector<ViewerPoint> firsts;
  for (const ViewerPoint& point : points) {
    if (taken.insert(CubeOf(point.p_map.cast<double>(), point.stop, spacing)).second)
      firsts.push_back(point);
  }
  return firsts;
}

/// Drops the vertices that no triangle has.
slam::TriangleMesh WithoutLooseVertices(const slam::TriangleMesh& mesh) {
  constexpr std::uint32_t kLoose = 0xFFFFFFFF;
  std::vector<std::uint32_t> moved(mesh.vertices.size(), kLoose);
  slam::TriangleMesh compact;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    std::array<std::uint32_t, 3>& corners = compact.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& place = moved[triangle[k]];
      if (place == kLoose) {
        place = static_cast<std::uint32_t>(compact.vertices.size());
        compact.vertices.push_back(mesh.vertices[triangle[k]]);
        if (!mesh.colors.empty()) compact.colors.push_back(mesh.colors[triangle[k]]);
      }
      corners[k] = place;
    }
  }
  return compact;
}

slam::TriangleMesh Clustered(const slam::TriangleMesh& mesh, double spacing) {
  std::unordered_map<CubeKey, std::uint32_t, CubeHash> first;
  std::vector<std::uint32_t> representative;
  for (const Eigen::Vector3d& p_map : mesh.vertices) {
    const auto index = static_cast<std::uint32_t>(representative.size());
    representative.push_back(first.try_emplace(CubeOf(p_map, 0, spacing), index).first->second);
  }
  slam::TriangleMesh clustered{mesh.vertices, {}, mesh.colors};
  for (const std::array<std::uint32_t, 3>& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> corners{representative[t[0]], representative[t[1]],
                                               representative[t[2]]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      clustered.triangles.push_back(corners);
  }
  return clustered;
}

}  // namespace

ThinnedPoints ThinPoints(std::vector<ViewerPoint> points, std::size_t max_points) {
  if (points.size() <= max_points) return {std::move(points), 0.0};
  ThinnedPoints thinned;
  thinned.spacing = kFirstSpacing;
  for (;;) {
    thinned.points = FirstOfEachCube(points, thinned.spacing);
    if (thinned.points.size() <= max_points) return thinned;
    if (thinned.spacing > kLastSpacing) break;  // more scans than points
    thinned.spacing = NextSpacing(thinned.spacing, thinned.points.size(), max_points);
  }
  thinned.points.resize(max_points);
  return thinned;
}

ThinnedMesh ThinMesh(slam::TriangleMesh mesh_map, std::size_t max_triangles) {
  if (mesh_map.triangles.size() <= max_triangles) return {std::move(mesh_map), 0.0};
  ThinnedMesh thinned{{}, kFirstSpacing};
  for (;;) {
    thinned.mesh_map = Clustered(mesh_map, thinned.spacing);
    const std::size_t count = thinned.mesh_map.triangles.size();
    if (count <= max_triangles) break;
    thinned.spacing = NextSpacing(thinned.spacing, count, max_triangles);
  }
  thinned.mesh_map = WithoutLooseVertices(thinned.mesh_map);
  return thinned;
}

}  // namespace ariadne::experiments
