#pragma once

#include <tsl/robin_map.h>

#include <span>
#include <vector>

#include "slam/geometry/pose3.h"
#include "slam/map/scan_mesh_triangles.h"

namespace ariadne::slam {

struct ScanPatch {
  ScanTriangles mesh_laser;
  Pose3 T_map_laser;
};

/// Which scan stands for the surface where several have seen it; see MeshOfScans.
class SurfaceCover {
 public:
  /// The patches must live as long as the cover. Error where a vertex is more than 2^20 cells from the
  /// origin.
  SurfaceCover(std::span<const ScanPatch> patches, const MeshOfScansOptions& options);

  /// Whether a triangle of a patch belongs to the whole.
  bool Keeps(std::size_t patch, const std::array<std::uint32_t, 3>& triangle) const;

 private:
  /// What one scan has seen in a cell.
  struct Claim {
    std::size_t patch;
    double area = 0.0;  // [m^2]
    double spacing =
        0.0;  // mean of range / cos incidence, weighted by area [m]; while it is gathered, the sum
    Eigen::Vector3d normals = Eigen::Vector3d::Zero();  // sum, weighted by area
  };
  /// A triangle as the claims count it.
  struct Facet {
    Eigen::Vector3d center_map;
    Eigen::Vector3d normal_map;  // unit length
    double area;
    double spacing;
  };
  struct KeyHash {
    std::size_t operator()(std::uint64_t key) const {
      key *= 0x9E3779B97F4A7C15ULL;
      return key ^ key >> 32;
    }
  };

  Facet FacetOf(std::size_t patch, const std::array<std::uint32_t, 3>& triangle) const;
  std::uint64_t KeyOf(const Eigen::Vector3d& p_map) const;

  std::span<const ScanPatch> patches_;
  double cell_;
  double min_share_;
  tsl::robin_map<std::uint64_t, std::vector<Claim>, KeyHash> cells_;  // claims in the order of the patches
};

}  // namespace ariadne::slam
