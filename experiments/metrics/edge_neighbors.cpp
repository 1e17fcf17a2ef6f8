#include "experiments/metrics/edge_neighbors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ariadne::experiments {
namespace {

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

}  // namespace

std::vector<std::vector<std::uint32_t>> FindEdgeNeighbors(const drivers::TriangleMesh& mesh, double weld) {
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

}  // namespace ariadne::experiments
