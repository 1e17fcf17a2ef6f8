#include <benchmark/benchmark.h>
#include <pcl/octree/octree_pointcloud_voxelcentroid.h>
#include <pcl/octree/octree_search.h>
#include <pcl/point_types.h>

#include "experiments/bench/corridor_tour.h"

// PCL's octrees on the points of octree_bench.cpp, as one cloud: PCL keeps the cloud, 16 bytes per point,
// which are not counted here.
namespace ariadne::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr TourCloud() {
  auto cloud = std::make_shared<Cloud>();
  for (const TourScan& scan : CorridorTour()) {
    for (const Eigen::Vector3d& p : scan.cloud_map.positions) {
      cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
  }
  return cloud;
}

template <typename Tree>
void Build(benchmark::State& state) {
  const Cloud::Ptr cloud = TourCloud();
  const auto points = static_cast<double>(cloud->size());
  double bytes = 0.0;
  double leaves = 0.0;
  for (auto _ : state) {
    const double before = AllocatedBytes();
    auto tree = std::make_unique<Tree>(kLeafSize);
    tree->setInputCloud(cloud);
    tree->addPointsFromInputCloud();
    benchmark::DoNotOptimize(tree.get());
    bytes = AllocatedBytes() - before;
    leaves = static_cast<double>(tree->getLeafCount());
    state.PauseTiming();  // for taking it down
    tree.reset();
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cloud->size()));
  state.counters["bytes_per_point"] = bytes / points;
  state.counters["leaves"] = leaves;
}

void BuildSearch(benchmark::State& state) {
  Build<pcl::octree::OctreePointCloudSearch<pcl::PointXYZ>>(state);
}
void BuildCentroids(benchmark::State& state) {
  Build<pcl::octree::OctreePointCloudVoxelCentroid<pcl::PointXYZ>>(state);
}

BENCHMARK(BuildSearch)->Name("octree/build/pcl_search")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BuildCentroids)->Name("octree/build/pcl_centroids")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace ariadne::bench
