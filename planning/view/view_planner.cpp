#include "planning/view/view_planner.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "planning/path/geodesic.h"
#include "planning/view/frontier_places.h"
#include "planning/view/view_policy.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

/// What one decision looks at.
struct Scene {
  std::vector<slam::Polygon2> area;
  std::vector<Edge> edges;
  FreeSpace free;
  GeodesicField ways;
  RayGain gain;

  Scene(std::span<const LabelledPolygon> polygons, const slam::Pose2& T_map_robot,
        const ViewPlannerOptions& options)
      : area(Plain(polygons)),
        edges(EdgesOf(polygons)),
        free(area, options.free_space),
        ways(DistancesFrom(free, T_map_robot.translation, options.robot_radius)),
        gain(edges, T_map_robot.angle, options.view.gain) {}

  static std::vector<slam::Polygon2> Plain(std::span<const LabelledPolygon> polygons) {
    std::vector<slam::Polygon2> plain;
    for (const LabelledPolygon& polygon : polygons) plain.push_back(ToPolygon2(polygon));
    return plain;
  }
};

using PieceNumbers = std::map<std::pair<std::size_t, long>, std::uint32_t>;

/// Judged candidates, and what the policies need of them.
struct Judged {
  std::vector<View> views;
  std::vector<std::vector<EdgePiece>> pieces;
  PieceNumbers numbers;
};

/// The pieces of unseen edges that the rays of a view meet.
std::vector<EdgePiece> PiecesOf(const Scene& scene, const View& view, std::span<const RayHit> hits,
                                double length, PieceNumbers& numbers) {
  std::map<std::uint32_t, double> gains;
  for (const std::size_t i : scene.gain.RaysAbout(view.direction)) {
    if (!scene.gain.IsUnseen(hits[i])) continue;
    const Eigen::Vector2d p = view.p_map + hits[i].distance * scene.gain.Direction(i);
    const double along = (p - scene.edges[hits[i].edge].from).norm();
    const std::pair piece(hits[i].edge, static_cast<long>(along / length));
    const auto number =
        numbers.try_emplace(piece, static_cast<std::uint32_t>(numbers.size())).first->second;
    gains[number] += scene.gain.GainOf(hits[i]);
  }
  std::vector<EdgePiece> pieces;
  for (const auto& [number, gain] : gains) pieces.push_back({number, gain});
  return pieces;
}

void Judge(const Scene& scene, const Eigen::Vector2d& p_map, double way, const slam::Pose2& T_map_robot,
           const ViewPlannerOptions& options, Judged& judged) {
  const std::vector<RayHit> hits = scene.gain.Cast(p_map);
  const ViewGain best = scene.gain.Of(hits);
  View view{p_map, best.direction, best.gain, best.area, best.overlap, way, 0.0, 0.0};
  if (options.way == WayLength::kStraight) view.distance = (p_map - T_map_robot.translation).norm();
  view.turn = std::abs(slam::WrapAngle(best.direction - T_map_robot.angle));
  view.value = std::exp(LogValue(view, options.view));
  judged.views.push_back(view);
  if (!LooksAhead(options.policy)) return;
  judged.pieces.push_back(PiecesOf(scene, view, hits, options.piece, judged.numbers));
}

/// Judges the places that the robot can get to, up to a number.
Judged JudgeReachable(const Scene& scene, std::span<const Eigen::Vector2d> places, std::size_t count,
                      const slam::Pose2& T_map_robot, const ViewPlannerOptions& options) {
  Judged judged;
  for (const Eigen::Vector2d& p_map : places) {
    if (judged.views.size() == count) break;
    if (!scene.free.IsFree(p_map, options.robot_radius)) continue;
    const double way = scene.ways.To(p_map);
    if (std::isfinite(way)) Judge(scene, p_map, way, T_map_robot, options, judged);
  }
  return judged;
}

/// Chooses among the judged views, where any is worth a stop.
std::optional<std::size_t> Choose(const Scene& scene, const Judged& judged,
                                  const ViewPlannerOptions& options, std::uint64_t seed) {
  ViewChoice choice{judged.views, {}, judged.pieces, {}};
  for (std::size_t i = 0; i < judged.views.size(); ++i) {
    const View& view = judged.views[i];
    if (view.gain >= options.view.min_gain && view.overlap >= options.min_overlap)
      choice.worth.push_back(i);
  }
  if (choice.worth.empty()) return {};
  choice.ways = [&](std::size_t from, std::span<const std::size_t> to) {
    const GeodesicField ways = DistancesFrom(scene.free, judged.views[from].p_map, options.robot_radius);
    std::vector<double> lengths;
    for (const std::size_t i : to) lengths.push_back(ways.To(judged.views[i].p_map));
    return lengths;
  };
  return ChooseView(choice, options, seed);
}

/// More than can be used, since some places keep too little distance from walls, or cannot be reached.
std::vector<Eigen::Vector2d> Places(const Scene& scene, const ViewPlannerOptions& options,
                                    std::uint64_t seed) {
  CandidateOptions more = options.candidates;
  more.count *= 3;
  return DrawCandidates(scene.area, scene.edges, more, seed);
}

}  // namespace

ViewPlannerOptions PaperViewPlannerOptions() {
  ViewPlannerOptions options;
  options.policy = ViewPolicy::kExponential;
  options.way = WayLength::kStraight;
  options.second_look = 0;
  options.view = PaperNextViewOptions();
  return options;
}

std::vector<Edge> EdgesOf(std::span<const LabelledPolygon> area) {
  std::vector<Edge> edges;
  const auto append = [&](const LabelledRing& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i].p_map, ring[(i + 1) % ring.size()].p_map, ring[i].seen});
    }
  };
  for (const LabelledPolygon& polygon : area) {
    append(polygon.outer);
    for (const LabelledRing& hole : polygon.holes) append(hole);
  }
  return edges;
}

ViewPlan PlanNextView(std::span<const LabelledPolygon> area, const slam::Pose2& T_map_robot,
                      const ViewPlannerOptions& options, std::uint64_t seed) {
  CheckOptions(options, "planner.");
  const Scene scene(area, T_map_robot, options);
  const auto count = static_cast<std::size_t>(options.candidates.count);
  const bool by_frontier = options.policy == ViewPolicy::kNearestFrontier;
  const auto second = static_cast<std::size_t>(options.second_look);
  ViewPlan plan;
  Judged judged;
  if (!by_frontier)
    judged = JudgeReachable(scene, Places(scene, options, seed), count, T_map_robot, options);
  plan.chosen = Choose(scene, judged, options, seed);
  if (!plan.chosen && (by_frontier || second > 0)) {
    plan.second_look = !by_frontier;
    const auto places = FrontierPlaces(scene.edges, scene.free, options.robot_radius);
    judged = JudgeReachable(scene, places, by_frontier ? count : second, T_map_robot, options);
    plan.chosen = Choose(scene, judged, options, seed);
  }
  plan.views = std::move(judged.views);
  if (!plan.views.empty()) plan.status = plan.chosen ? NextViewStatus::kFound : NextViewStatus::kNoGain;
  if (plan.chosen) plan.path_map = scene.ways.PathTo(plan.views[*plan.chosen].p_map);
  return plan;
}

}  // namespace ariadne::planning
