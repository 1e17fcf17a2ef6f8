#pragma once

#include <array>
#include <span>
#include <string_view>

#include "slam/base/options.h"
#include "slam/geometry/triangle_mesh.h"
#include "slam/map/octree.h"

namespace ariadne::slam {

/// What the colour of a voxel says.
enum class VoxelColoring { kReflectance, kHeight };

struct VoxelMeshOptions {
  VoxelColoring coloring = VoxelColoring::kReflectance;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("coloring", self.coloring,
          "reflectance is the paper's (6.1), as a grey; height is told by any scanner");
  }
};

/// The octree mesh of the paper (Sec. 6.1, Fig. 11): the cubes of the cells, each in its colour, without
/// the faces between two cells of one size, which nobody sees. Cells are those of Octree::Cells. Voxels
/// share no vertices, as each has its own colour; counted by place, every edge is passed as often one way
/// as the other, so that the mesh is closed around every group of cells of one size.
TriangleMesh VoxelMesh(std::span<const OctreeCell> cells, const VoxelMeshOptions& options);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::VoxelColoring> {
  static constexpr std::array<std::string_view, 2> value{"reflectance", "height"};
};

}  // namespace ariadne
