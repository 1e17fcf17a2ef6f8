#include <benchmark/benchmark.h>
#include <open3d/geometry/KDTreeFlann.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/GeneralizedICP.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/pipelines/registration/TransformationEstimation.h>

#include "experiments/bench/bench_data.h"

// Open3D on the same clouds, with the same gate and number of iterations.
namespace ariadne::bench {
namespace {

namespace registration = open3d::pipelines::registration;

open3d::geometry::PointCloud ToOpen3d(const slam::PointCloud& cloud) {
  return open3d::geometry::PointCloud(cloud.positions);
}

void AlignWhole(benchmark::State& state, bool reduced) {
  const BenchPair& pair = Pair();
  const auto model = ToOpen3d(reduced ? pair.model_reduced : pair.model);
  const auto data = ToOpen3d(reduced ? pair.data_reduced : pair.data);
  const registration::ICPConvergenceCriteria criteria(0.0, 0.0,
                                                      Iterations(reduced));  // its own stop rules off
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        registration::RegistrationICP(data, model, kMaxDistance, pair.T_model_data_guess.Matrix(),
                                      registration::TransformationEstimationPointToPoint(false), criteria));
  }
  state.counters["icp_iterations"] = criteria.max_iteration_;
}

void BuildTree(benchmark::State& state) {
  const auto model = ToOpen3d(Pair().model);
  for (auto _ : state) benchmark::DoNotOptimize(open3d::geometry::KDTreeFlann(model));
}

void VoxelGrid(benchmark::State& state) {
  const auto model = ToOpen3d(Pair().model);
  for (auto _ : state) benchmark::DoNotOptimize(model.VoxelDownSample(0.1));
}

// OMP_NUM_THREADS, which ./dev bench sets, decides how many threads Open3D uses.
BENCHMARK_CAPTURE(AlignWhole, reduced, true)
    ->Name("point_to_point/open3d/reduced/threads:1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(AlignWhole, all, false)
    ->Name("point_to_point/open3d/all/threads:1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BuildTree)->Name("tree/build_open3d/all")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(VoxelGrid)->Name("reduce/voxel_mean_open3d/all")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace ariadne::bench

BENCHMARK_MAIN();
