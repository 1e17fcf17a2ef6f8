#include "planning/path/roadmap.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/planners/prm/PRMstar.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "planning/path/ompl_support.h"

namespace ariadne::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr std::size_t kJoined = 10;  // vertices next to a place that is not one

/// Neighbours by looking at all; OMPL's other structures draw numbers. It leaves their distance undefined.
class LinearPrmStar : public og::PRMstar {
 public:
  explicit LinearPrmStar(const ob::SpaceInformationPtr& info) : og::PRMstar(info) {
    setNearestNeighbors<ompl::NearestNeighborsLinear>();
    nn_->setDistanceFunction([this](const Vertex a, const Vertex b) { return distanceFunction(a, b); });
  }
};

Roadmap CopyOf(const og::PRM& planner, double radius) {
  Roadmap roadmap;
  roadmap.radius = radius;
  const og::PRM::Graph& graph = planner.getRoadmap();
  const auto state_of = boost::get(og::PRM::vertex_state_t(), graph);
  for (std::size_t i = 0; i < boost::num_vertices(graph); ++i) {
    roadmap.vertices_map.push_back(internal::PlaceOf(state_of[i]));
  }
  const auto [begin, end] = boost::edges(graph);
  for (auto edge = begin; edge != end; ++edge) {
    const std::size_t from = boost::source(*edge, graph), to = boost::target(*edge, graph);
    roadmap.ways.push_back({from, to, (roadmap.vertices_map[from] - roadmap.vertices_map[to]).norm()});
  }
  return roadmap;
}

struct Link {
  std::size_t vertex;
  double length;  // [m]
};

/// The nearest vertices that are in sight of p.
std::vector<Link> LinksTo(const FreeSpace& space, const Roadmap& roadmap, const Eigen::Vector2d& p_map) {
  std::vector<Link> all, links;
  for (std::size_t i = 0; i < roadmap.vertices_map.size(); ++i) {
    all.push_back({i, (roadmap.vertices_map[i] - p_map).norm()});
  }
  std::ranges::stable_sort(all, {}, &Link::length);
  for (const Link& link : all) {
    if (links.size() == kJoined) break;
    if (space.IsWayFree(p_map, roadmap.vertices_map[link.vertex], roadmap.radius)) links.push_back(link);
  }
  return links;
}

/// Dijkstra's algorithm from the vertices that the start sees.
std::vector<double> DistancesOfVertices(const Roadmap& roadmap, const std::vector<Link>& start) {
  std::vector<std::vector<Link>> neighbours(roadmap.vertices_map.size());
  for (const Roadmap::Way& way : roadmap.ways) {
    neighbours[way.from].push_back({way.to, way.length});
    neighbours[way.to].push_back({way.from, way.length});
  }
  std::vector<double> distance(neighbours.size(), kUnreached);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](std::size_t vertex, double length) {
    if (length >= distance[vertex]) return;
    distance[vertex] = length;
    queue.emplace(length, vertex);
  };
  for (const Link& link : start) reach(link.vertex, link.length);
  while (!queue.empty()) {
    const Entry next = queue.top();
    queue.pop();
    if (next.first > distance[next.second]) continue;
    for (const Link& link : neighbours[next.second]) reach(link.vertex, next.first + link.length);
  }
  return distance;
}

}  // namespace

Roadmap BuildRoadmap(const FreeSpace& space, double radius, const RoadmapOptions& options,
                     std::uint64_t seed) {
  CheckOptions(options, "roadmap.");
  internal::RequireRadius(radius);
  if (space.columns() == 0) return {radius, {}, {}};
  const internal::OmplSilence silence;
  const ob::SpaceInformationPtr info = internal::PlaneOfDisc(space, radius, seed);
  info->setValidStateSamplerAllocator([](const ob::SpaceInformation* of) {
    auto sampler = std::make_shared<ob::UniformValidStateSampler>(of);
    sampler->setNrAttempts(1);  // counted here
    return sampler;
  });
  const auto problem = std::make_shared<ob::ProblemDefinition>(info);
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(info));
  LinearPrmStar planner(info);
  planner.setProblemDefinition(problem);
  planner.setup();
  // Not solve(), which starts a thread and grows by the clock. Asked after at most a few draws.
  const auto most = static_cast<std::size_t>(options.vertices);
  std::size_t asked = 0;
  planner.growRoadmap(ob::PlannerTerminationCondition([&] {
    return planner.milestoneCount() >= most || asked++ > most * static_cast<std::size_t>(options.max_draws);
  }));
  return CopyOf(planner, radius);
}

std::vector<double> RoadmapDistances(const FreeSpace& space, const Roadmap& roadmap,
                                     const Eigen::Vector2d& start_map,
                                     std::span<const Eigen::Vector2d> places_map) {
  const std::vector<double> of_vertices = DistancesOfVertices(roadmap, LinksTo(space, roadmap, start_map));
  std::vector<double> distances;
  for (const Eigen::Vector2d& p_map : places_map) {
    double& distance = distances.emplace_back(kUnreached);
    if (space.IsWayFree(start_map, p_map, roadmap.radius)) distance = (p_map - start_map).norm();
    if (distance < kUnreached) continue;
    for (const Link& link : LinksTo(space, roadmap, p_map)) {
      distance = std::min(distance, of_vertices[link.vertex] + link.length);
    }
  }
  return distances;
}

}  // namespace ariadne::planning
