#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "experiments/bench/factor_bench.h"
#include "experiments/bench/stock_ceres.h"
#include "slam/base/blas_guard.h"
#include "slam/base/error.h"
#include "slam/graph/factors/optimize_with_ceres.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/optimize/certificate.h"
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
    const BlasGuard guard;
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

/// The proof that the minimum is the global one.
void Prove(benchmark::State& state, const PublicGraph& which) {
  OnGraph(state, which, [](const auto& graph, benchmark::State& s) {
    const auto result = slam::Optimize(graph, {});
    for (auto _ : s) {
      if (slam::Certify(result.graph).verdict != slam::CertificateVerdict::kOptimal)
        s.SkipWithError("the minimum is not certified");
    }
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
      const BlasGuard guard;
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

template <typename Function, typename... Args>
void Register(const std::string& name, Function function, Args... args) {
  benchmark::RegisterBenchmark(name.c_str(), function, args...)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterGraphs() {
  for (const PublicGraph& graph : kGraphs) {
    const std::string path = std::string("graph/") + graph.name;
    Register(path + "/ariadne", Whole, graph);
    Register(path + "/floor", Floor, graph);
    Register(path + "/certificate", Prove, graph);
    Register(path + "/ceres_suite_sparse", Ceres, graph, slam::CeresLibrary::kSuiteSparse, 1e16);
    Register(path + "/ceres_eigen", Ceres, graph, slam::CeresLibrary::kEigen, 1e16);
    Register(path + "/ceres_cxsparse", Ceres, graph, slam::CeresLibrary::kCxSparse, 1e16);
    Register(path + "/ceres_default_radius", Ceres, graph, slam::CeresLibrary::kSuiteSparse, 1e4);
    if (graph.optimum_by_guess) Register(path + "/ceres_stock", StockCeres, graph);
  }
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
