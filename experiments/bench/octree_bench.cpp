#include <benchmark/benchmark.h>
#include <octomap/octomap.h>
#include <sys/resource.h>

#include <string>
#include <string_view>

#include "experiments/bench/corridor_tour.h"
#include "slam/base/random.h"
#include "slam/base/stopwatch.h"
#include "slam/map/octree.h"

// The octree of the map beside octomap's, on the same points with the same leaves. PCL's is measured in a
// program of its own. Ours keeps count, mean, normal and reflectance of a leaf; octomap's only whether it
// is occupied, PCL's the indices of its points, or their mean.
namespace ariadne::bench {
namespace {

std::size_t TourPoints() {
  std::size_t points = 0;
  for (const TourScan& scan : CorridorTour()) points += scan.cloud_map.size();
  return points;
}

/// Builds a tree once per iteration, and says what it takes.
template <typename Build>
void Measure(benchmark::State& state, const Build& build) {
  const auto points = static_cast<double>(TourPoints());
  double bytes = 0.0;
  for (auto _ : state) {
    const double before = AllocatedBytes();
    const auto tree = build();
    benchmark::DoNotOptimize(tree.get());
    bytes = AllocatedBytes() - before;
    state.PauseTiming();  // for taking it down
    const_cast<std::remove_const_t<decltype(tree)>&>(tree).reset();
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["bytes_per_point"] = bytes / points;
}

std::unique_ptr<slam::Octree> BuildOurs() {
  auto tree = std::make_unique<slam::Octree>(slam::OctreeOptions{kLeafSize});
  for (const TourScan& scan : CorridorTour()) tree->Add(scan.cloud_map, scan.viewpoint_map);
  return tree;
}

/// The end points only, without the rays that octomap would clear: the fastest that it offers.
std::unique_ptr<octomap::OcTree> BuildOctomap() {
  auto tree = std::make_unique<octomap::OcTree>(kLeafSize);
  constexpr bool kOccupied = true, kLazy = true;
  for (const TourScan& scan : CorridorTour()) {
    for (const Eigen::Vector3d& p : scan.cloud_map.positions) {
      tree->updateNode(tree->coordToKey(p.x(), p.y(), p.z()), kOccupied, kLazy);
    }
  }
  tree->updateInnerOccupancy();
  return tree;
}

void Ours(benchmark::State& state) {
  Measure(state, BuildOurs);
  const auto tree = BuildOurs();
  state.counters["leaves"] = static_cast<double>(tree->leaves());
  state.counters["bytes_by_own_count"] =
      static_cast<double>(tree->bytes()) / static_cast<double>(tree->points());
}

void Octomap(benchmark::State& state) {
  Measure(state, BuildOctomap);
  state.counters["leaves"] = static_cast<double>(BuildOctomap()->getNumLeafNodes());
}

void Cells(benchmark::State& state) {
  const auto tree = BuildOurs();
  for (auto _ : state) benchmark::DoNotOptimize(tree->Cells(static_cast<int>(state.range(0))));
}

/// A hundred million points: the tour again and again, each scan with its own shift and each point with its
/// own noise. Only the building is timed.
void Stream(benchmark::State& state) {
  constexpr std::size_t kPoints = 100'000'000;
  RandomStream stream = NamedStream(1, "octree_bench");
  std::vector<double> noise(1 << 16);
  for (double& n : noise) n = DrawNormal(stream, 0.0, 0.01);
  for (auto _ : state) {
    slam::Octree tree({kLeafSize});
    double seconds = 0.0;
    while (tree.points() < kPoints) {
      for (const TourScan& scan : CorridorTour()) {
        slam::PointCloud cloud_map = scan.cloud_map;
        std::size_t n = stream() % noise.size();
        const Eigen::Vector3d shift(noise[stream() % noise.size()], noise[stream() % noise.size()], 0.0);
        for (Eigen::Vector3d& p : cloud_map.positions) {
          for (int axis = 0; axis < 3; ++axis) p[axis] += shift[axis] + noise[n++ % noise.size()];
        }
        const Stopwatch stopwatch;
        tree.Add(cloud_map, scan.viewpoint_map + shift);
        seconds += stopwatch.Seconds();
      }
    }
    state.SetIterationTime(seconds);
    state.SetItemsProcessed(static_cast<std::int64_t>(tree.points()));
    state.counters["leaves"] = static_cast<double>(tree.leaves());
    state.counters["bytes_per_point"] =
        static_cast<double>(tree.bytes()) / static_cast<double>(tree.points());
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1e3;  // of the program: kB in Linux
}

BENCHMARK(Ours)->Name("octree/build/ariadne")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Octomap)->Name("octree/build/octomap")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Cells)
    ->Name("octree/cells/depth")
    ->Arg(5)
    ->Arg(8)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  // Takes a while: only where the filter names it (./dev bench stream).
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]).find("stream") == std::string_view::npos) continue;
    benchmark::RegisterBenchmark("octree/stream/100M_points", ariadne::bench::Stream)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->UseManualTime();
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
