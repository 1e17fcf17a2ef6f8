#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "experiments/bench/stock_ceres.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "slam/base/single_threaded_openmp.h"
#include "slam/graph/factors/compressed_factors.h"
#include "slam/graph/factors/optimize_with_ceres.h"
#include "slam/graph/factors/pose_block.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/optimize/chordal.h"
#include "slam/graph/optimize/normal_system.h"
#include "slam/graph/optimize/optimize.h"
#include "slam/io/g2o.h"
#include "slam/sparse/block_cholesky.h"

// Pose graphs, whole and in parts, in SE-Sync's objective, and the factors of many point pairs. The names
// are paths that experiments/bench/run.py compares.
namespace ariadne::bench {
namespace {

struct PublicGraph {
  const char* name;
  double optimum;         // certified by SE-Sync
  bool optimum_by_guess;  // also reached from the file's own guess
};
constexpr PublicGraph kGraphs[] = {
    {"sphere2500", 1687.005810, true},  {"torus3D", 24227.0456, false},
    {"cubicle", 717.125991, false},     {"parking-garage", 1.262524, true},
    {"smallGrid3D", 1025.398060, true}, {"kitti_00", 125.693515, false},
    {"intel", 52.348227, true},         {"MIT", 61.154116, false},
    {"manhattan", 6431.391390, false},
};

std::filesystem::path GraphFolder() {
  const char* const data = std::getenv("ARIADNE_DATA");
  return std::filesystem::path(data == nullptr ? "." : data) / "graphs";
}

slam::G2oFile Read(const PublicGraph& graph) {
  const std::string name = std::string(graph.name) + ".g2o";
  std::ifstream in(GraphFolder() / name);
  if (!in) Fail("cannot open {}", (GraphFolder() / name).string());
  return slam::ReadG2o(in, name);
}

/// Runs on the graph in SE-Sync's objective: body(graph, state) returns the objective that it has reached.
template <typename Body>
void OnGraph(benchmark::State& state, const PublicGraph& which, const Body& body) {
  std::visit(
      [&](const auto& graph) {
        const double objective = body(slam::Isotropic(graph), state);
        state.counters["objective"] = objective;
        if (objective > which.optimum * (1.0 + 1e-6)) state.SkipWithError("the optimum is missed");
      },
      Read(which).graph);
}

int Factorizations(const std::vector<slam::GraphIteration>& iterations) {
  int count = 0;
  for (const slam::GraphIteration& iteration : iterations) count += iteration.factorizations;
  return count;
}

/// From the measurements to the minimum: chordal start, ordering, all iterations.
void Whole(benchmark::State& state, const PublicGraph& which) {
  OnGraph(state, which, [](const auto& graph, benchmark::State& s) {
    double objective = 0.0;
    for (auto _ : s) {
      const auto result = slam::Optimize(graph, {});
      objective = result.objective;
      s.counters["factorizations"] = Factorizations(result.iterations);
      s.counters["start_ms"] = 1e3 * result.times.start;
      s.counters["symbolic_ms"] = 1e3 * result.times.symbolic;
      s.counters["linearize_ms"] = 1e3 * result.times.linearize;
      s.counters["factorize_ms"] = 1e3 * result.times.factorize;
      s.counters["solve_ms"] = 1e3 * result.times.solve;
    }
    return objective;
  });
}

/// What no Newton method can be faster than: as many numeric factorizations of the matrix at the minimum as
/// Whole takes, and nothing else.
void Floor(benchmark::State& state, const PublicGraph& which) {
  OnGraph(state, which, [](const auto& graph, benchmark::State& s) {
    const SingleThreadedOpenMp single_threaded;
    const auto result = slam::Optimize(graph, {});
    slam::NormalSystem system(result.graph);
    system.Linearize(result.graph, {}, slam::Hessian::kNewton);
    slam::BlockCholesky factor(system.H());
    const int count = Factorizations(result.iterations);
    for (auto _ : s) {
      for (int k = 0; k < count; ++k) {
        if (!factor.Factorize(system.H())) Fail("the matrix at the minimum is not positive definite");
      }
    }
    s.counters["factorizations"] = count;
    return result.objective;
  });
}

void Ceres(benchmark::State& state, const PublicGraph& which, slam::CeresLibrary library, double radius) {
  OnGraph(state, which, [&](const auto& graph, benchmark::State& s) {
    slam::CeresTuning tuning;
    tuning.library = library;
    tuning.initial_trust_region_radius = radius;
    double objective = 0.0;
    for (auto _ : s) {
      const SingleThreadedOpenMp single_threaded;
      auto started = graph;
      slam::InitializeByChords(started, slam::FindVariables(started));
      const auto result = slam::OptimizeWithCeres(started, {}, tuning);
      objective = result.objective;
      s.counters["factorizations"] = result.factorizations;
    }
    return objective;
  });
}

/// As tutorials do it, from the file's guess.
void StockCeres(benchmark::State& state, const PublicGraph& which) {
  OnGraph(state, which, [](const auto& graph, benchmark::State& s) {
    double objective = 0.0;
    for (auto _ : s) objective = OptimizeWithStockCeres(graph);
    return objective;
  });
}

template <typename Moments>
void AddPair(Moments& moments, RandomStream& stream) {
  const auto draw = [&] {
    return Eigen::Vector3d(DrawNormal(stream, 0, 5), DrawNormal(stream, 0, 5), 1.0);
  };
  const Eigen::Vector3d p = draw();
  const Eigen::Vector3d noise = 0.01 * draw();
  if constexpr (std::is_same_v<Moments, slam::PointMoments>) {
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
    if constexpr (std::is_same_v<Moments, slam::PointMoments>)
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
      if constexpr (std::is_same_v<Moments, slam::PointMoments>)
        moments.Add(p, p);
      else
        moments.Add(p, p, Eigen::Matrix3d::Identity());
    }
    benchmark::DoNotOptimize(moments);
  }
  state.SetItemsProcessed(state.iterations() * 1000);
}

template <typename Function, typename... Args>
benchmark::internal::Benchmark* Register(const std::string& name, Function function, Args... args) {
  return benchmark::RegisterBenchmark(name.c_str(), function, args...)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterGraphs() {
  for (const PublicGraph& graph : kGraphs) {
    const std::string path = std::string("graph/") + graph.name;
    Register(path + "/ariadne", Whole, graph);
    Register(path + "/floor", Floor, graph);
    Register(path + "/ceres_suite_sparse", Ceres, graph, slam::CeresLibrary::kSuiteSparse, 1e16);
    Register(path + "/ceres_eigen", Ceres, graph, slam::CeresLibrary::kEigen, 1e16);
    Register(path + "/ceres_cxsparse", Ceres, graph, slam::CeresLibrary::kCxSparse, 1e16);
    Register(path + "/ceres_default_radius", Ceres, graph, slam::CeresLibrary::kSuiteSparse, 1e4);
    if (graph.optimum_by_guess) Register(path + "/ceres_stock", StockCeres, graph);
  }
}

void RegisterFactors() {
  for (const std::size_t pairs : {10, 1000, 100000}) {
    const std::string suffix = "/pairs:" + std::to_string(pairs);
    Register("factor/point" + suffix, EvaluateFactor<slam::PointMoments>, pairs)
        ->Unit(benchmark::kNanosecond);
    Register("factor/plane" + suffix, EvaluateFactor<slam::PlaneMoments>, pairs)
        ->Unit(benchmark::kNanosecond);
  }
  Register("factor/accumulate_point", Accumulate<slam::PointMoments>)->Unit(benchmark::kMicrosecond);
  Register("factor/accumulate_plane", Accumulate<slam::PlaneMoments>)->Unit(benchmark::kMicrosecond);
}

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const bool found = std::filesystem::exists(ariadne::bench::GraphFolder());
  benchmark::AddCustomContext("graphs", found ? "public graphs" : "missing: set ARIADNE_DATA");
  if (found) ariadne::bench::RegisterGraphs();
  ariadne::bench::RegisterFactors();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
