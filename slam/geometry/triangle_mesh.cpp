#include "slam/geometry/triangle_mesh.h"

namespace ariadne::slam {

void Append(TriangleMesh& mesh, const TriangleMesh& tail) {
  const bool keeps_colors =
      (mesh.vertices.empty() || !mesh.colors.empty()) && (tail.vertices.empty() || !tail.colors.empty());
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), tail.vertices.begin(), tail.vertices.end());
  mesh.colors.insert(mesh.colors.end(), tail.colors.begin(), tail.colors.end());
  if (!keeps_colors) mesh.colors.clear();
  for (const auto& [a, b, c] : tail.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace ariadne::slam
