#include "slam/map/scan_mesh_cover.h"

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::slam {

SurfaceCover::SurfaceCover(std::span<const ScanPatch> patches, const MeshOfScansOptions& options)
    : patches_(patches), cell_(options.cell), min_share_(options.min_share) {
  for (std::size_t s = 0; s < patches.size(); ++s) {
    for (const auto& triangle : patches[s].mesh_laser.triangles) {
      const Facet facet = FacetOf(s, triangle);
      std::vector<Claim>& claims = cells_[KeyOf(facet.center_map)];
      // The two sides of a thin wall are claims of their own.
      const auto same = std::ranges::find_if(claims, [&](const Claim& claim) {
        return claim.patch == s && claim.normals.dot(facet.normal_map) > 0.0;
      });
      Claim& claim = same != claims.end() ? *same : claims.emplace_back(Claim{.patch = s});
      claim.area += facet.area;
      claim.spacing += facet.area * facet.spacing;
      claim.normals += facet.area * facet.normal_map;
    }
  }
}

/// The surface may lie on the border of two cells, and be on either side for two scans: the cells before
/// and behind count as well.
bool SurfaceCover::Keeps(std::size_t patch, const std::array<std::uint32_t, 3>& triangle) const {
  const Facet facet = FacetOf(patch, triangle);
  Eigen::Index axis = 0;
  facet.normal_map.cwiseAbs().maxCoeff(&axis);
  std::vector<Claim> seen;  // by each scan, in the three cells
  for (const double step : {-1.0, 0.0, 1.0}) {
    const auto found = cells_.find(KeyOf(facet.center_map + step * cell_ * Eigen::Vector3d::Unit(axis)));
    if (found == cells_.end()) continue;
    for (const Claim& claim : found->second) {
      constexpr double kSameSide = 0.5;  // within 60 deg
      if (claim.normals.dot(facet.normal_map) < kSameSide * claim.normals.norm()) continue;
      const auto same = std::ranges::find(seen, claim.patch, &Claim::patch);
      Claim& sum = same != seen.end() ? *same : seen.emplace_back(Claim{.patch = claim.patch});
      sum.area += claim.area;
      sum.spacing += claim.spacing;
    }
  }
  double largest = 0.0;
  for (const Claim& claim : seen) largest = std::max(largest, claim.area);
  const Claim* best = nullptr;
  for (const Claim& claim : seen) {
    if (claim.area < min_share_ * largest) continue;
    const auto rank = [](const Claim& c) { return std::pair(c.spacing / c.area, c.patch); };
    if (best == nullptr || rank(claim) < rank(*best)) best = &claim;
  }
  return best == nullptr || best->patch == patch;  // null: the triangle differs from all in its cell
}

SurfaceCover::Facet SurfaceCover::FacetOf(std::size_t patch,
                                          const std::array<std::uint32_t, 3>& triangle) const {
  const std::vector<Eigen::Vector3d>& vertices_laser = patches_[patch].mesh_laser.vertices_laser;
  const Pose3& T_map_laser = patches_[patch].T_map_laser;
  const auto corner = [&](std::size_t i) { return T_map_laser * vertices_laser[triangle[i]]; };
  const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2);
  const Eigen::Vector3d across = (b - a).cross(c - a);
  Facet facet;
  facet.center_map = (a + b + c) / 3.0;
  facet.area = std::max(0.5 * across.norm(), 1e-12);  // beams that meet still count a little
  facet.normal_map = across.stableNormalized();
  const Eigen::Vector3d beam_map = facet.center_map - T_map_laser.translation;
  constexpr double kGrazing = 0.05;  // no less: noise may turn a small triangle any way
  const double cosine = std::max(kGrazing, std::abs(facet.normal_map.dot(beam_map.stableNormalized())));
  facet.spacing = beam_map.norm() / cosine;
  return facet;
}

std::uint64_t SurfaceCover::KeyOf(const Eigen::Vector3d& p_map) const {
  constexpr double kHalf = 1 << 20;
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double place = std::floor(p_map[axis] / cell_);
    if (!(std::abs(place) < kHalf - 1)) {
      Fail("mesh.cell is too small for coordinates this large: at most 2^20 cells to each side");
    }
    key = key << 21 | static_cast<std::uint64_t>(place + kHalf);
  }
  return key;
}

}  // namespace ariadne::slam
