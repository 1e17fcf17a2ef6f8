#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"
#include "drivers/simulated/safety_scanners.h"

// The simulated scanners. The names are paths that experiments/bench/run.py compares.
namespace ariadne::bench {
namespace {

using drivers::AisScannerOptions;
using drivers::RayScene;

struct Place {
  std::string name;
  RayScene scene;
  std::vector<slam::Pose2> stations;  // where the base stands: in offices and in corridors, 1 m from walls
};

slam::Pose2 At(double x, double y, double angle) { return {angle, {x, y}}; }

Place LoadPlace() {
  const char* data = std::getenv("ARIADNE_DATA");
  const std::string mesh =
      std::string(data == nullptr ? "" : data) + "/worlds/willowgarage/meshes/willowgarage_visual.dae";
  if (std::filesystem::exists(mesh)) {
    return {"willowgarage",
            RayScene(drivers::LoadWorld(mesh)),
            {At(20, 10, 0.0), At(20, 16, 1.0), At(38, 10, 2.0), At(35, 31, 3.0), At(44, 37, 4.0),
             At(14, 19, 5.0)}};
  }
  drivers::World robobench = drivers::LoadWorld("builtin:robobench");
  const slam::Pose2 start = robobench.T_map_start;
  return {"built-in robobench", RayScene(std::move(robobench)), {start}};
}

const Place& ThePlace() {
  static const Place kPlace = LoadPlace();
  return kPlace;
}

slam::Pose3 Station(std::size_t i) {
  const auto& stations = ThePlace().stations;
  return slam::ToPose3(stations[i % stations.size()]);
}

/// Whole scans of 181 x 256 points with all noise, or without any; one after another at all stations.
void TakeScans(benchmark::State& state, bool noise, int threads) {
  AisScannerOptions options;
  if (!noise) options.range_finder = drivers::WithoutErrors(options.range_finder);
  const Parallel parallel(threads);
  std::size_t number = 0;
  double returns = 0.0;
  for (auto _ : state) {
    const slam::Scan scan =
        drivers::TakeAisScan(ThePlace().scene, Station(number), 0.0, options, 1, number, parallel);
    ++number;
    for (const slam::LaserSweep& sweep : scan.sweeps) {
      for (const float range : sweep.ranges) returns += range > 0.0F ? 1.0 : 0.0;
    }
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["returns"] = returns / static_cast<double>(state.iterations());
}

/// The beams of whole scans, one ray each, already computed.
void CastRays(benchmark::State& state, int threads) {
  const AisScannerOptions options;
  const drivers::SweepMounting mounting = drivers::AisMounting(options);
  std::vector<drivers::Ray> rays;
  for (std::size_t i = 0; i < ThePlace().stations.size(); ++i) {
    for (int s = 0; s < options.slices; ++s) {
      const double step = (options.highest_pitch - options.lowest_pitch) / options.slices;
      const auto beams = drivers::SweepBeams(mounting, drivers::Standing(Station(i)), 0.0,
                                             options.lowest_pitch + s * step, 0.0);
      rays.insert(rays.end(), beams.begin(), beams.end());
    }
  }
  std::vector<drivers::Hit> hits(rays.size());
  const Parallel parallel(threads);
  for (auto _ : state) {
    parallel.For(rays.size(), 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
      ThePlace().scene.Cast(std::span(rays).subspan(begin, end - begin),
                            std::span(hits).subspan(begin, end - begin));
    });
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

void TakeSafety(benchmark::State& state) {
  std::size_t number = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(drivers::TakeSafetySweeps(ThePlace().scene, drivers::Standing(Station(number)),
                                                       0.0, {}, 1, number));
    ++number;
  }
  state.SetItemsProcessed(state.iterations());
}

template <typename Function, typename... Args>
void Register(const std::string& name, Function function, Args... args) {
  benchmark::RegisterBenchmark(name.c_str(), function, args...)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterAll() {
  for (const int threads : {1, 2}) {
    const std::string suffix = "/threads:" + std::to_string(threads);
    Register("simulated/scan" + suffix, TakeScans, true, threads);
    Register("simulated/scan_without_errors" + suffix, TakeScans, false, threads);
    Register("simulated/rays" + suffix, CastRays, threads);
  }
  Register("simulated/safety_sweeps", TakeSafety);
}

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("world", ariadne::bench::ThePlace().name);
  ariadne::bench::RegisterAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
