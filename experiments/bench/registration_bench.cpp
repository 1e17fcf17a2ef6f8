#include <benchmark/benchmark.h>

#include <stdexcept>

#include "experiments/bench/bench_data.h"
#include "experiments/bench/plain_loop.h"
#include "slam/reduce/reduce.h"
#include "slam/registration/align.h"
#include "slam/registration/correspondence_tracker.h"

// Registration kernel by kernel. The names are paths that experiments/bench/ratios.py compares.
namespace ariadne::bench {
namespace {

struct Clouds {
  const slam::PointCloud& model;
  const slam::PointCloud& data;
};

Clouds Choose(bool reduced) {
  const BenchPair& pair = Pair();
  return reduced ? Clouds{pair.model_reduced, pair.data_reduced} : Clouds{pair.model, pair.data};
}

void BuildTree(benchmark::State& state, bool reduced) {
  for (auto _ : state) benchmark::DoNotOptimize(slam::KdTree(Choose(reduced).model.positions));
}

void EstimateSurfaces(benchmark::State& state, bool reduced) {
  const slam::KdTree tree(Choose(reduced).model.positions);
  for (auto _ : state) benchmark::DoNotOptimize(slam::EstimateSurfaces(tree, 10, Parallel(1)));
}

void Find(benchmark::State& state, bool reduced, bool brute_force) {
  const auto& [model, data] = Choose(reduced);
  const slam::KdTree tree(model.positions);
  const slam::Pose3& guess = Pair().T_model_data_guess;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        brute_force
            ? slam::FindByBruteForce(model.positions, data.positions, guess, kMaxDistance, Parallel(1))
            : slam::FindByKdTree(tree, data.positions, guess, kMaxDistance, Parallel(1)));
  }
}

void ReduceWith(benchmark::State& state, slam::ReduceMethod method) {
  const slam::PointCloud& cloud = Pair().model;
  for (auto _ : state) benchmark::DoNotOptimize(slam::Reduce(cloud, {.method = method}));
}

void Plain(benchmark::State& state, bool reduced, int threads) {
  const auto& [model, data] = Choose(reduced);
  for (auto _ : state) {
    const PlainResult result = PlainLoop(model.positions, data.positions, Pair().T_model_data_guess,
                                         kMaxDistance, kConvergenceRms, threads);
    state.counters["icp_iterations"] = result.iterations;
  }
}

slam::AlignOptions Options(slam::Metric metric, int threads, bool assess) {
  slam::AlignOptions options;
  options.metric = metric;
  options.max_distance = kMaxDistance;
  options.convergence_rms = kConvergenceRms;
  // The plane metrics settle within a few iterations; a tenth of a millimetre is below what they can tell.
  if (metric != slam::Metric::kPointToPoint) options.convergence_step = 1e-4;
  options.threads = threads;
  options.assess = assess;
  return options;
}

/// The whole alignment, from the points: trees, surfaces, iterations.
void AlignWhole(benchmark::State& state, bool reduced, slam::Metric metric, int threads, bool assess) {
  const auto& [model, data] = Choose(reduced);
  const slam::AlignOptions options = Options(metric, threads, assess);
  for (auto _ : state) {
    const slam::AlignResult result = slam::Align(model, data, Pair().T_model_data_guess, options);
    state.counters["icp_iterations"] = static_cast<double>(result.iterations.size());
  }
  if (metric != slam::Metric::kPointToPoint) return;
  const PlainResult plain = PlainLoop(model.positions, data.positions, Pair().T_model_data_guess,
                                      kMaxDistance, kConvergenceRms, 1);
  const slam::AlignResult result = slam::Align(model, data, Pair().T_model_data_guess, options);
  if (slam::TranslationDistance(plain.T_model_data, result.T_model_data) > 1e-9 ||
      plain.iterations != static_cast<int>(result.iterations.size())) {
    state.SkipWithError("Align and the plain loop disagree");
  }
}

/// The iterations and the assessment alone, with trees and surfaces prepared, as in matching many scans.
void AlignPrepared(benchmark::State& state, bool reduced, slam::Metric metric, int threads) {
  const auto& [model, data] = Choose(reduced);
  const slam::AlignOptions options = Options(metric, threads, true);
  const slam::AlignModel prepared_model = slam::PrepareModel(model, options);
  const slam::AlignData prepared_data = slam::PrepareData(data, options);
  for (auto _ : state) {
    const slam::AlignResult result =
        slam::Align(prepared_model, prepared_data, Pair().T_model_data_guess, options);
    state.counters["icp_iterations"] = static_cast<double>(result.iterations.size());
  }
}

template <typename Function, typename... Args>
void Register(const std::string& name, Function function, Args... args) {
  benchmark::RegisterBenchmark(name.c_str(), function, args...)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterAll() {
  using slam::Metric;
  for (const bool reduced : {true, false}) {
    const std::string points = reduced ? "reduced" : "all";
    Register("tree/build/" + points, BuildTree, reduced);
    Register("tree/surfaces/" + points, EstimateSurfaces, reduced);
    Register("pairs/kd_tree/" + points, Find, reduced, false);
    if (reduced) Register("pairs/brute_force/" + points, Find, reduced, true);
    for (const int threads : {1, 2}) {
      const std::string suffix = "/" + points + "/threads:" + std::to_string(threads);
      Register("point_to_point/plain_loop" + suffix, Plain, reduced, threads);
      Register("point_to_point/ariadne" + suffix, AlignWhole, reduced, Metric::kPointToPoint, threads,
               false);
      Register("point_to_point/ariadne_assessed" + suffix, AlignWhole, reduced, Metric::kPointToPoint,
               threads, true);
      Register("point_to_plane/ariadne" + suffix, AlignWhole, reduced, Metric::kPointToPlane, threads,
               true);
      Register("plane_to_plane/ariadne" + suffix, AlignWhole, reduced, Metric::kPlaneToPlane, threads,
               true);
      Register("plane_to_plane/ariadne_prepared" + suffix, AlignPrepared, reduced, Metric::kPlaneToPlane,
               threads);
    }
  }
  Register("reduce/slices/all", ReduceWith, slam::ReduceMethod::kSlices);
  Register("reduce/voxel_mean/all", ReduceWith, slam::ReduceMethod::kVoxelMean);
  Register("reduce/octree_center/all", ReduceWith, slam::ReduceMethod::kOctreeCenter);
}

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("data", ariadne::bench::Pair().name);
  ariadne::bench::RegisterAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
