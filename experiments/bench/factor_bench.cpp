#include "experiments/bench/factor_bench.h"

#include <benchmark/benchmark.h>

#include <string>
#include <type_traits>
#include <vector>

#include "slam/base/random.h"
#include "slam/graph/factors/compressed_factors.h"
#include "slam/graph/factors/pose_block.h"

namespace ariadne::bench {
namespace {

template <typename Moments>
void AddPair(Moments& moments, RandomStream& stream) {
  const auto draw = [&] {
    return Eigen::Vector3d(DrawNormal(stream, 0, 5), DrawNormal(stream, 0, 5), 1.0);
  };
  const Eigen::Vector3d p = draw();
  const Eigen::Vector3d noise = 0.01 * draw();
  if constexpr (std::is_same_v<Moments, slam::PointPairMoments>) {
    moments.Add(p, p + noise);
  } else {
    const Eigen::Vector3d normal = draw().normalized();
    moments.Add(p, p + noise, normal * normal.transpose());
  }
}

/// Residuals and Jacobians of the factor that stands for `pairs` point pairs.
template <typename Moments>
void EvaluateFactor(benchmark::State& state, std::size_t pairs) {
  RandomStream stream = NamedStream(1, "graph_bench");
  Moments moments;
  for (std::size_t k = 0; k < pairs; ++k) AddPair(moments, stream);
  const auto factor = [&] {
    if constexpr (std::is_same_v<Moments, slam::PointPairMoments>)
      return slam::MakePointFactor(moments);
    else
      return slam::MakePlaneFactor(moments);
  }();
  const auto block = slam::ToBlock(slam::Pose3());
  const double* const parameters[] = {block.data(), block.data()};
  double residuals[21], by_i[21 * 7], by_j[21 * 7];
  double* jacobians[] = {by_i, by_j};
  for (auto _ : state) {
    factor->Evaluate(parameters, residuals, jacobians);
    benchmark::DoNotOptimize(by_j);
  }
}

/// Adding pairs to the moments, which is done once per round of pairing.
template <typename Moments>
void Accumulate(benchmark::State& state) {
  RandomStream stream = NamedStream(1, "graph_bench");
  std::vector<Eigen::Vector3d> points(1000);
  for (Eigen::Vector3d& p : points) p << DrawNormal(stream, 0, 5), DrawNormal(stream, 0, 5), 1.0;
  for (auto _ : state) {
    Moments moments;
    for (const Eigen::Vector3d& p : points) {
      if constexpr (std::is_same_v<Moments, slam::PointPairMoments>)
        moments.Add(p, p);
      else
        moments.Add(p, p, Eigen::Matrix3d::Identity());
    }
    benchmark::DoNotOptimize(moments);
  }
  state.SetItemsProcessed(state.iterations() * 1000);
}

template <typename Function, typename... Args>
void Register(const std::string& name, benchmark::TimeUnit unit, Function function, Args... args) {
  benchmark::RegisterBenchmark(name.c_str(), function, args...)->Unit(unit)->UseRealTime();
}

}  // namespace

void RegisterFactors() {
  for (const std::size_t pairs : {10, 1000, 100000}) {
    const std::string suffix = "/pairs:" + std::to_string(pairs);
    Register("factor/point" + suffix, benchmark::kNanosecond, EvaluateFactor<slam::PointPairMoments>,
             pairs);
    Register("factor/plane" + suffix, benchmark::kNanosecond, EvaluateFactor<slam::PlanePairMoments>,
             pairs);
  }
  Register("factor/accumulate_point", benchmark::kMicrosecond, Accumulate<slam::PointPairMoments>);
  Register("factor/accumulate_plane", benchmark::kMicrosecond, Accumulate<slam::PlanePairMoments>);
}

}  // namespace ariadne::bench
