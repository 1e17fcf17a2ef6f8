#pragma once

#include <string>

#include "slam/map/scan_mesh.h"

namespace ariadne::slam {

/// The mesh of one scan with what is needed to choose among several. Points without a triangle are left
/// out.
struct ScanTriangles {
  std::vector<Eigen::Vector3d> vertices_laser;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> reflectance;  // empty, or one per vertex
};

/// See MeshScan; `name` says in errors which cloud.
ScanTriangles TrianglesOf(const PointCloud& cloud_laser, const ScanMeshOptions& options,
                          const std::string& name);

}  // namespace ariadne::slam
