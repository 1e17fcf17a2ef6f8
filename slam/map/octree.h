#pragma once

#include <cstdint>
#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/box3.h"
#include "slam/map/octree_bricks.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct OctreeOptions {
  double leaf_size = 0.05;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("leaf_size", self.leaf_size, Unit("m"), Range{1e-3, 100.0},
          "edge of the smallest cells; open in the paper (6.1), 0.05 is 1-2 times the scanner's noise");
  }
};

/// A cube of the tree with what is known of the points in it.
struct OctreeCell {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // [m]
  double edge = 0.0;                                 // [m]
  std::uint64_t count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // of the points [m]
  /// Of the surface, unit length, towards the nearest viewpoint; zero where the points do not span a plane.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  float reflectance = 0.0F;  // mean; NaN where a point's was NaN; 0 without reflectance
};

/// The octree of the paper (Sec. 6.1) for point streams of any length: leaves are cubes of one fixed
/// lattice and hold statistics instead of points, so that memory grows with the surface that was seen, not
/// with how often. It is linear: what lies above the leaves is computed when it is asked for.
///
/// What comes out does not depend on the order of the points, but for rounding: leaves are stored with 24
/// bits. Means are right to 1e-5 of a leaf's edge up to 10^6 visits of a leaf by runs of points, and mostly
/// to 1e-7.
class Octree {
 public:
  /// Error where an option is out of its range.
  explicit Octree(const OctreeOptions& options);

  /// Adds the points of a scan. `viewpoint_map` is where the laser was: normals look to it. Where clouds
  /// with and without reflectance come together, there is none. Error, and the tree remains as it was,
  /// where a coordinate is not finite or beyond 2^20 leaves from the origin.
  void Add(const PointCloud& cloud_map, const Eigen::Vector3d& viewpoint_map);

  /// The occupied cells of a depth, in the order of the Morton curve: 0 is the bounding cube of all leaves,
  /// max_depth() and more are the leaves. Statistics are those of all points in a cell. Error below 0.
  std::vector<OctreeCell> Cells(int depth) const;
  /// Those of them that hold a point of the box; cells are half open.
  std::vector<OctreeCell> CellsIn(const Box3& box_map, int depth) const;

  std::uint64_t points() const { return points_; }
  std::size_t leaves() const { return leaves_; }
  bool has_reflectance() const { return has_reflectance_; }
  double leaf_size() const { return edge_; }
  /// How often the bounding cube is halved until its parts are leaves.
  int max_depth() const;
  /// Of memory, without this object itself [B].
  std::size_t bytes() const { return bricks_.bytes(); }

 private:
  class Run;
  void Check(const PointCloud& cloud_map, const Eigen::Vector3d& viewpoint_map) const;
  void AddRun(const Run& run, const Eigen::Vector3d& viewpoint_map);
  std::vector<OctreeCell> CellsBetween(const LeafIndex& from, const LeafIndex& to, int levels) const;
  LeafIndex IndexOf(const Eigen::Vector3d& p_map) const;

  double edge_;
  double per_edge_;
  OctreeBricks bricks_;
  LeafIndex low_ = LeafIndex::Zero();   // of all leaves
  LeafIndex high_ = LeafIndex::Zero();  // included
  std::uint64_t points_ = 0;
  std::size_t leaves_ = 0;
  bool has_reflectance_ = false;
};

}  // namespace ariadne::slam
