#include <benchmark/benchmark.h>
#include <pcl/common/transforms.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>

#include "experiments/bench/bench_data.h"

// The Point Cloud Library on the same clouds, with the same gate and number of iterations.
namespace ariadne::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr ToPcl(const slam::PointCloud& cloud) {
  auto converted = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& p : cloud.positions) {
    converted->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                            static_cast<float>(p.z()));
  }
  return converted;
}

template <typename Registration>
void AlignWhole(benchmark::State& state, bool reduced) {
  const BenchPair& pair = Pair();
  const Cloud::Ptr model = ToPcl(reduced ? pair.model_reduced : pair.model);
  const Cloud::Ptr data = ToPcl(reduced ? pair.data_reduced : pair.data);
  const int iterations = Iterations(reduced);
  for (auto _ : state) {
    Registration registration;
    registration.setMaxCorrespondenceDistance(kMaxDistance);
    registration.setMaximumIterations(iterations);
    if constexpr (std::is_same_v<Registration,
                                 pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ, double>>) {
      registration.setTransformationEpsilon(0.0);  // its own stop rules off
      registration.setEuclideanFitnessEpsilon(-1.0);
    }
    registration.setInputTarget(model);
    registration.setInputSource(data);
    Cloud aligned;
    registration.align(
        aligned, pair.T_model_data_guess.Matrix().template cast<typename Registration::Matrix4::Scalar>());
    benchmark::DoNotOptimize(registration.getFinalTransformation());
  }
  state.counters["icp_iterations"] = iterations;
}

void BuildTree(benchmark::State& state) {
  const Cloud::Ptr model = ToPcl(Pair().model);
  for (auto _ : state) {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(model);
    benchmark::DoNotOptimize(tree);
  }
}

void VoxelGrid(benchmark::State& state) {
  const Cloud::Ptr model = ToPcl(Pair().model);
  for (auto _ : state) {
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setLeafSize(0.1F, 0.1F, 0.1F);
    grid.setInputCloud(model);
    Cloud reduced;
    grid.filter(reduced);
    benchmark::DoNotOptimize(reduced);
  }
}

using Icp = pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ, double>;
using Gicp = pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ>;

void AlignIcp(benchmark::State& state, bool reduced) { AlignWhole<Icp>(state, reduced); }
void AlignGicp(benchmark::State& state, bool reduced) { AlignWhole<Gicp>(state, reduced); }

BENCHMARK_CAPTURE(AlignIcp, reduced, true)
    ->Name("point_to_point/pcl/reduced/threads:1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(AlignIcp, all, false)
    ->Name("point_to_point/pcl/all/threads:1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(AlignGicp, reduced, true)
    ->Name("plane_to_plane/pcl/reduced/threads:1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BuildTree)->Name("tree/build_pcl/all")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(VoxelGrid)->Name("reduce/voxel_mean_pcl/all")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace ariadne::bench

BENCHMARK_MAIN();
