#pragma once

#include <array>
#include <cstdint>

#include "slam/base/options.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// How the points of a scan are made fewer before matching.
enum class ReduceMethod {
  kNone,
  kSlices,        // the paper's reduced points (Sec. 2.2.1 step 1)
  kVoxelMean,     // the mean of each cell of a fixed grid
  kOctreeCenter,  // the center of each leaf of an octree, as 3DTK does by default
  kOctreeMean,    // the mean of each leaf
  kOctreeRandom,  // one random point of each leaf
};

struct ReduceOptions {
  ReduceMethod method = ReduceMethod::kNone;
  double join_distance = 0.2;
  int keep_every = 3;
  double voxel_size = 0.1;
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method, "how points are made fewer; slices is the paper's (2.2.1)");
    visit("join_distance", self.join_distance, Unit("m"), Range{0.0, 10.0},
          "slices: neighbours of a slice this close are joined; open in the paper, makes 46336 points "
          "about 4900");
    visit("keep_every", self.keep_every, Unit("slices"), Range{1, 1000},
          "slices: only every so many-th slice is kept; 3 in the group's later papers");
    visit("voxel_size", self.voxel_size, Unit("m"), Range{1e-4, 1e3},
          "edge of a voxel; largest edge of an octree leaf (0.2 gives the cells of 3DTK's -r 10)");
    visit("seed", self.seed, Unit(""), Range{0, 2147483647}, "octree_random: which point of each leaf");
  }
};

PointCloud Reduce(const PointCloud& cloud, const ReduceOptions& options);

/// Sec. 2.2.1: in every keep_every-th slice, runs of points within join_distance [m] of their first point
/// become their mean. The cloud must be organized. The result is organized too.
PointCloud ReduceSlices(const PointCloud& cloud, double join_distance, int keep_every);

/// One point, the mean, per cell of the grid of edge voxel_size [m] through the origin.
PointCloud ReduceVoxels(const PointCloud& cloud, double voxel_size);

enum class Representative { kCenter, kMean, kRandom };

/// One point per leaf of the octree over the cloud's bounding cube, halved until an edge is at most
/// voxel_size [m].
PointCloud ReduceOctree(const PointCloud& cloud, double voxel_size, Representative representative,
                        std::uint64_t seed);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::ReduceMethod> {
  static constexpr std::array<std::string_view, 6> value{"none",          "slices",      "voxel_mean",
                                                         "octree_center", "octree_mean", "octree_random"};
};

}  // namespace ariadne
