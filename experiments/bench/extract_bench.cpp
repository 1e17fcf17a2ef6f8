#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"
#include "slam/extract/extract_surfaces.h"
#include "slam/extract/objects.h"
#include "slam/extract/slice_points.h"

// Lines, surfaces and objects of scans of 181 x 256 points. The names are paths that
// experiments/bench/run.py compares. What runs while the scanner turns is given per slice: 13 ms are there.
namespace ariadne::bench {
namespace {

using slam::LineMethod;
using slam::PlanarSurface;
using slam::PointCloud;

/// Scans of the corridor and of a room beside it, in the laser frame.
const std::vector<PointCloud>& Scans() {
  static const std::vector<PointCloud> kScans = [] {
    const drivers::RayScene scene(drivers::LoadWorld("builtin:robobench"));
    const drivers::AisScannerOptions options;
    std::vector<PointCloud> scans;
    for (const slam::Pose2& stop :
         {slam::Pose2{0.0, {2.6, 0.0}}, slam::Pose2{1.5, {6.0, 0.0}}, slam::Pose2{3.1, {12.0, 0.0}}}) {
      scans.push_back(slam::ToPointCloud(
          drivers::TakeAisScan(scene, slam::ToPose3(stop), 0.0, options, 1, scans.size(), Parallel(1))));
    }
    return scans;
  }();
  return kScans;
}

slam::LineOptions OptionsOf(LineMethod method) {
  slam::LineOptions options;
  options.method = method;
  return options;
}

/// Calls work(scan, slice) for one slice after another.
void PerSlice(benchmark::State& state, const auto& work) {
  std::size_t scan = 0, slice = 0;
  for (auto _ : state) {
    work(Scans()[scan], slice);
    if (++slice < Scans()[scan].slice_begin.size()) continue;
    slice = 0;
    scan = (scan + 1) % Scans().size();
  }
}

void Lines(benchmark::State& state, LineMethod method) {
  const slam::LineOptions options = OptionsOf(method);
  PerSlice(state, [&](const PointCloud& scan, std::size_t slice) {
    benchmark::DoNotOptimize(slam::DetectLines(slam::SlicePoints(scan, slice), options));
  });
}

void LinesAndGrowing(benchmark::State& state, LineMethod method) {
  const slam::LineOptions options = OptionsOf(method);
  slam::SurfaceGrower grower({});
  PerSlice(state, [&](const PointCloud& scan, std::size_t slice) {
    if (slice == 0) grower = slam::SurfaceGrower({});
    grower.AddSlice(slam::SpatialLines(scan, slice, options));
  });
}

/// Calls work(scan number) for one scan after another.
void PerScan(benchmark::State& state, const auto& work) {
  std::size_t scan = 0;
  for (auto _ : state) {
    work(scan);
    scan = (scan + 1) % Scans().size();
  }
}

/// What the paper does after the scan: polygons, their union, objects.
void Offline(benchmark::State& state) {
  std::vector<slam::SurfaceGrower> growers;
  for (const PointCloud& scan : Scans()) {
    growers.emplace_back(slam::SurfaceOptions{});
    for (std::size_t s = 0; s < scan.slice_begin.size(); ++s) {
      growers.back().AddSlice(slam::SpatialLines(scan, s, {}));
    }
  }
  PerScan(state, [&](std::size_t scan) {
    const std::vector<PlanarSurface> surfaces = slam::UniteSurfaces(growers[scan].Surfaces(), {});
    benchmark::DoNotOptimize(slam::SegmentObjects(surfaces, {}));
  });
}

void Regions(benchmark::State& state) {
  PerScan(state, [](std::size_t scan) { benchmark::DoNotOptimize(slam::GrowRegions(Scans()[scan], {})); });
}

template <typename Function, typename... Args>
void Register(const std::string& name, benchmark::TimeUnit unit, Function function, Args... args) {
  benchmark::RegisterBenchmark(name.c_str(), function, args...)->Unit(unit)->UseRealTime();
}

void RegisterAll() {
  for (const LineMethod method :
       {LineMethod::kLengthRatio, LineMethod::kHough, LineMethod::kSplitAndMerge}) {
    const std::string name(NameOf(method));
    Register("extract/lines_of_a_slice/" + name, benchmark::kMicrosecond, Lines, method);
    Register("extract/surfaces_per_slice/" + name, benchmark::kMicrosecond, LinesAndGrowing, method);
  }
  Register("extract/offline", benchmark::kMillisecond, Offline);
  Register("extract/region_growing", benchmark::kMillisecond, Regions);
}

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("scans",
                              std::to_string(ariadne::bench::Scans().size()));  // made before any timing
  ariadne::bench::RegisterAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
