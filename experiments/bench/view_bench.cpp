#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "planning/view/next_view.h"
#include "planning/view/uniform_candidates.h"
#include "slam/base/random.h"

// Planning the next view in a building of 30 x 20 m, and its growth with candidates and edges. The names
// are paths that experiments/bench/run.py compares.
namespace ariadne::bench {
namespace {

using planning::Edge;
using Places = std::vector<Eigen::Vector2d>;

const slam::Pose2 kRobot{0.3, {3.0, 3.0}};

slam::Ring Box(double x, double y, double width, double depth) {
  return {{x, y}, {x, y + depth}, {x + width, y + depth}, {x + width, y}};
}

/// A hall with six blocks of rooms, between which corridors run.
slam::Polygon2 Building() {
  slam::Polygon2 building{{{0.0, 0.0}, {30.0, 0.0}, {30.0, 20.0}, {0.0, 20.0}}, {}};
  for (const double x : {4.0, 13.0, 22.0}) {
    for (const double y : {4.0, 12.0}) building.holes.push_back(Box(x, y, 5.0, 4.0));
  }
  return building;
}

/// The outline of the building in about `count` pieces, one in five of them unseen.
std::vector<Edge> Pieces(int count) {
  RandomStream stream = NamedStream(1, "view_bench");
  const double length = slam::Perimeter(Building()) / count;
  std::vector<Edge> pieces;
  for (const Edge& edge : planning::EdgesOf(Building(), true)) {
    const Eigen::Vector2d along = edge.to - edge.from;
    const int parts = std::max(1, static_cast<int>(std::lround(along.norm() / length)));
    for (int i = 0; i < parts; ++i) {
      pieces.push_back({edge.from + along * i / parts, edge.from + along * (i + 1) / parts,
                        DrawUniform(stream, 0.0, 1.0) > 0.2});
    }
  }
  return pieces;
}

Places Candidates(int count) {
  planning::CandidateOptions options;
  options.count = count;
  return planning::DrawCandidates(std::array{Building()}, {}, options, 1);
}

/// From the polygon to the decision, as the robot does it.
void Plan(benchmark::State& state, int candidates, int edges) {
  const std::vector<Edge> pieces = Pieces(edges);
  for (auto _ : state) {
    benchmark::DoNotOptimize(planning::ChooseNextView(Candidates(candidates), pieces, kRobot, {}));
  }
  state.counters["edges"] = static_cast<double>(pieces.size());
}

/// The label of the nearest edge that a ray meets, by looking at all of them.
bool MeetsUnseen(const std::vector<Edge>& edges, const Eigen::Vector2d& p, const Eigen::Vector2d& u) {
  double nearest = 15.0;
  bool unseen = false;
  for (const Edge& edge : edges) {
    const Eigen::Vector2d a = edge.from - p, along = edge.to - edge.from;
    const double turn = u.x() * along.y() - u.y() * along.x();
    const double share = (a.x() * u.y() - a.y() * u.x()) / turn;
    const double distance = (a.x() * along.y() - a.y() * along.x()) / turn;
    if (share >= 0.0 && share < 1.0 && distance >= 0.0 && distance < nearest) {
      nearest = distance, unseen = !edge.seen;
    }
  }
  return unseen && nearest >= 0.5;
}

/// The gain alone, ray by ray: each of 360 with each edge.
void PlainLoop(benchmark::State& state, int candidates, int edges) {
  const std::vector<Edge> pieces = Pieces(edges);
  const Places places = Candidates(candidates);
  for (auto _ : state) {
    int unseen = 0;
    for (const Eigen::Vector2d& p : places) {
      for (int ray = 0; ray < 360; ++ray) {
        const double angle = kRobot.angle + ray * std::numbers::pi / 180.0;
        unseen += MeetsUnseen(pieces, p, {std::cos(angle), std::sin(angle)});
      }
    }
    benchmark::DoNotOptimize(unseen);
  }
}

void Register(const std::string& what, int candidates, int edges, auto function) {
  const std::string name =
      "view/" + what + "/candidates:" + std::to_string(candidates) + "/edges:" + std::to_string(edges);
  benchmark::RegisterBenchmark(name.c_str(), function, candidates, edges)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterAll() {
  for (const int candidates : {50, 100, 400, 800}) Register("plan", candidates, 1000, Plan);
  for (const int edges : {100, 300, 1000, 3000, 10000}) Register("plan", 200, edges, Plan);
  Register("plain_loop", 200, 1000, PlainLoop);
}

}  // namespace
}  // namespace ariadne::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  ariadne::bench::RegisterAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
