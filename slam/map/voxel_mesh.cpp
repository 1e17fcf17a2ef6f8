#include "slam/map/voxel_mesh.h"

#include <tsl/robin_map.h>
#include <tsl/robin_set.h>

#include <cmath>
#include <limits>

#include "slam/base/error.h"
#include "slam/map/voxel_mesh_colors.h"

namespace ariadne::slam {
namespace {

/// The cells of one edge, by their place in the lattice of their centers.
class Neighborhood {
 public:
  explicit Neighborhood(std::span<const OctreeCell> cells) {
    for (const OctreeCell& cell : cells) {
      if (!cell.center.allFinite() || !(cell.edge > 0.0)) {
        Fail("a cell to be meshed has no place or no size: center {} {} {}, edge {} m", cell.center.x(),
             cell.center.y(), cell.center.z(), cell.edge);
      }
      Lattice& lattice = lattices_.try_emplace(cell.edge, Lattice{cell.center, {}}).first.value();
      lattice.places.insert(lattice.Key(cell, Eigen::Vector3d::Zero()));
    }
  }

  bool HasNeighbor(const OctreeCell& cell, const std::array<int, 3>& step) const {
    const Lattice& lattice = lattices_.at(cell.edge);
    return lattice.places.contains(lattice.Key(cell, Eigen::Vector3d(step[0], step[1], step[2])));
  }

 private:
  struct KeyHash {
    std::size_t operator()(std::uint64_t key) const {
      key *= 0x9E3779B97F4A7C15ULL;
      return key ^ key >> 32;
    }
  };

  struct Lattice {
    Eigen::Vector3d origin;  // center of its first cell
    tsl::robin_set<std::uint64_t, KeyHash> places;

    std::uint64_t Key(const OctreeCell& cell, const Eigen::Vector3d& step) const {
      constexpr std::uint64_t kSpan = 1 << 21;  // the leaves of an octree on an axis
      const Eigen::Vector3d place = ((cell.center - origin) / cell.edge + step).array().round();
      std::uint64_t key = 0;
      for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(place[axis]) <= kSpan)) Fail("the cells to be meshed are not of one octree");
        key = key << 21 | static_cast<std::uint64_t>(place[axis] + kSpan) % kSpan;
      }
      return key;
    }
  };

  tsl::robin_map<double, Lattice> lattices_;
};

/// A corner of a cube as three bits, x lowest; and its faces, counterclockwise seen from outside.
struct Face {
  std::array<int, 3> outwards;
  std::array<unsigned, 4> corners;
};

constexpr std::array<Face, 6> kFaces{{{{-1, 0, 0}, {0, 4, 6, 2}},
                                      {{1, 0, 0}, {1, 3, 7, 5}},
                                      {{0, -1, 0}, {0, 1, 5, 4}},
                                      {{0, 1, 0}, {2, 6, 7, 3}},
                                      {{0, 0, -1}, {0, 2, 3, 1}},
                                      {{0, 0, 1}, {4, 5, 7, 6}}}};

Eigen::Vector3d CornerOf(const OctreeCell& cell, unsigned corner) {
  const Eigen::Vector3d side(corner & 1, corner >> 1 & 1, corner >> 2);
  return cell.center + cell.edge * (side.array() - 0.5).matrix();
}

std::vector<Rgb> ColorsOf(std::span<const OctreeCell> cells, VoxelColoring coloring) {
  std::vector<double> values;
  for (const OctreeCell& cell : cells) {
    values.push_back(coloring == VoxelColoring::kReflectance ? double{cell.reflectance} : cell.center.z());
  }
  return coloring == VoxelColoring::kReflectance ? GreyColors(values) : RainbowColors(values);
}

/// Adds the faces of a cell that have no neighbour, with the corners that they need.
void AddCell(TriangleMesh& mesh, const OctreeCell& cell, const Neighborhood& cells, const Rgb& color) {
  constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
  std::array<std::uint32_t, 8> vertices;
  vertices.fill(kNoVertex);
  const auto vertex = [&](unsigned corner) {
    if (vertices[corner] == kNoVertex) {
      if (mesh.vertices.size() >= kNoVertex)
        Fail("a mesh of so many voxels has more vertices than 32 bits count");
      vertices[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(CornerOf(cell, corner));
      mesh.colors.push_back(color);
    }
    return vertices[corner];
  };
  for (const Face& face : kFaces) {
    if (cells.HasNeighbor(cell, face.outwards)) continue;
    const auto& [a, b, c, d] = face.corners;
    mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    mesh.triangles.push_back({vertex(a), vertex(c), vertex(d)});
  }
}

}  // namespace

TriangleMesh VoxelMesh(std::span<const OctreeCell> cells, const VoxelMeshOptions& options) {
  const Neighborhood neighborhood(cells);
  const std::vector<Rgb> colors = ColorsOf(cells, options.coloring);
  TriangleMesh mesh;
  for (std::size_t i = 0; i < cells.size(); ++i) AddCell(mesh, cells[i], neighborhood, colors[i]);
  return mesh;
}

}  // namespace ariadne::slam
