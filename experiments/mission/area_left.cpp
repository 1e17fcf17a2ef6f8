#include "experiments/mission/area_left.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "planning/view/openings.h"
#include "planning/view/view_planner.h"

namespace ariadne::experiments {
namespace {

constexpr double kNeighbourhood = 4.0;  // that one view looks into [m]

}  // namespace

double UnseenLength(std::span<const planning::LabelledPolygon> area) {
  double length = 0.0;
  for (const planning::Edge& edge : planning::EdgesOf(area)) {
    if (!edge.seen) length += (edge.to - edge.from).norm();
  }
  return length;
}

double FreeArea(std::span<const planning::LabelledPolygon> area) {
  double sum = 0.0;
  for (const planning::LabelledPolygon& polygon : area) sum += slam::Area(planning::ToPolygon2(polygon));
  return sum;
}

int ViewsLeft(std::span<const planning::LabelledPolygon> area, double least) {
  const std::vector<planning::Edge> edges = planning::EdgesOf(area);
  const std::vector<double> openings = planning::Openings(area);
  std::vector<std::pair<double, Eigen::Vector2d>> left;  // openings with the middles of their edges
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (openings[i] > 0.0 && openings[i] >= least)
      left.push_back({openings[i], 0.5 * (edges[i].from + edges[i].to)});
  }
  std::ranges::stable_sort(left, std::ranges::greater(), [](const auto& opening) { return opening.first; });
  int views = 0;
  for (; !left.empty(); ++views) {
    const Eigen::Vector2d middle = left.front().second;
    std::erase_if(left, [&](const auto& other) { return (other.second - middle).norm() < kNeighbourhood; });
  }
  return views;
}

}  // namespace ariadne::experiments
