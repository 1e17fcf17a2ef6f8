#include "slam/reduce/reduce.h"

namespace ariadne::slam {

PointCloud Reduce(const PointCloud& cloud, const ReduceOptions& options) {
  const auto seed = static_cast<std::uint64_t>(options.seed);
  switch (options.method) {
    case ReduceMethod::kNone:
      return cloud;
    case ReduceMethod::kSlices:
      return ReduceSlices(cloud, options.join_distance, options.keep_every);
    case ReduceMethod::kVoxelMean:
      return ReduceVoxels(cloud, options.voxel_size);
    case ReduceMethod::kOctreeCenter:
      return ReduceOctree(cloud, options.voxel_size, Representative::kCenter, seed);
    case ReduceMethod::kOctreeMean:
      return ReduceOctree(cloud, options.voxel_size, Representative::kMean, seed);
    case ReduceMethod::kOctreeRandom:
      return ReduceOctree(cloud, options.voxel_size, Representative::kRandom, seed);
  }
  return cloud;
}

}  // namespace ariadne::slam
