#include "slam/map/scan_mesh.h"

#include "slam/map/scan_mesh_cover.h"
#include "slam/map/scan_mesh_triangles.h"
#include "slam/map/voxel_mesh_colors.h"

namespace ariadne::slam {

TriangleMesh MeshScan(const PointCloud& cloud_laser, const ScanMeshOptions& options) {
  CheckOptions(options, "mesh.");
  ScanTriangles scan = TrianglesOf(cloud_laser, options, "the scan to be meshed");
  TriangleMesh mesh{std::move(scan.vertices_laser), std::move(scan.triangles)};
  if (!scan.reflectance.empty()) mesh.colors = GreyColors(scan.reflectance);
  return mesh;
}

TriangleMesh MeshOfScans(std::span<const PosedCloud> scans, const MeshOfScansOptions& options) {
  CheckOptions(options, "mesh.");
  std::vector<ScanPatch> patches;
  bool reflecting = true;
  for (const PosedCloud& scan : scans) {
    patches.push_back({TrianglesOf(scan.cloud_laser, options.scan, scan.name), scan.T_map_laser});
    reflecting = reflecting && (scan.cloud_laser.empty() || !scan.cloud_laser.reflectance.empty());
  }
  TriangleMesh mesh;
  std::vector<double> reflectance;
  const SurfaceCover cover(patches, options);
  for (std::size_t s = 0; s < patches.size(); ++s) {
    const ScanTriangles& scan = patches[s].mesh_laser;
    std::vector<std::uint32_t> vertices(scan.vertices_laser.size());  // in the whole mesh, plus 1
    const auto vertex = [&](std::uint32_t v) {
      if (vertices[v] == 0) {
        mesh.vertices.push_back(patches[s].T_map_laser * scan.vertices_laser[v]);
        if (reflecting) reflectance.push_back(scan.reflectance[v]);
        vertices[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      }
      return vertices[v] - 1;
    };
    for (const auto& [a, b, c] : scan.triangles) {
      if (cover.Keeps(s, {a, b, c})) mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    }
  }
  if (reflecting) mesh.colors = GreyColors(reflectance);
  return mesh;
}

}  // namespace ariadne::slam
