#include "planning/view/view_planner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "planning/path/geodesic.h"
#include "planning/view/frontier_places.h"
#include "planning/view/looked_at.h"
#include "planning/view/openings.h"
#include "planning/view/view_policy.h"
#include "slam/base/random.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

constexpr double kSamePlaceAsRobot = 0.5;  // [m]
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kOverlappingGap = 1.5;  // fields of view between headings, less than that needs no scan

double ViewClearance(const ViewPlannerOptions& options) {
  return std::max(options.robot_radius, options.view_clearance);
}

/// What one decision looks at.
struct Scene {
  std::vector<slam::Polygon2> area;
  std::vector<Edge> edges;
  std::vector<double> openings;  // of the edges
  FreeSpace free;
  GeodesicField ways;
  RayGain gain;

  Scene(std::span<const LabelledPolygon> polygons, const slam::Pose2& T_map_robot,
        const ViewPlannerOptions& options, std::span<const Eigen::Vector2d> obstacles_map)
      : area(Plain(polygons)),
        edges(EdgesOf(polygons)),
        openings(Openings(polygons)),
        free(area, options.free_space, obstacles_map),
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

/// A decision in the making.
class Decision {
 public:
  Decision(const Scene& scene, const slam::Pose2& T_map_robot, const ViewPlannerOptions& options,
           std::uint64_t seed, const LookedAt& looked_at, const WayCost& way_cost)
      : scene_(scene),
        T_map_robot_(T_map_robot),
        options_(options),
        seed_(seed),
        looked_at_(looked_at),
        way_cost_(way_cost) {}

  /// Candidates that the robot can get to.
  std::vector<Eigen::Vector2d> DrawReachable() const;
  /// Uniformly from a disc.
  std::vector<Eigen::Vector2d> DrawAround(const Eigen::Vector2d& center) const;
  /// Those of the places that the robot can get to, up to a number.
  std::vector<Eigen::Vector2d> Reachable(std::span<const Eigen::Vector2d> places, int count) const;
  Judged Judge(std::span<const Eigen::Vector2d> places) const;
  void JudgeMore(std::span<const Eigen::Vector2d> places, Judged& judged) const;
  /// Among the judged views, where any is worth a stop.
  std::optional<std::size_t> Choose(const Judged& judged) const;

 private:
  bool IsReachable(const Eigen::Vector2d& p_map) const {
    return scene_.free.IsFree(p_map, ViewClearance(options_)) && std::isfinite(scene_.ways.To(p_map));
  }
  Eigen::Vector2d StartWithRoom(std::span<const Eigen::Vector2d> places) const;
  std::vector<double> Ways(std::span<const Eigen::Vector2d> places) const;
  std::vector<RayHit> Cast(const Eigen::Vector2d& p_map) const;
  View Look(const Eigen::Vector2d& p_map, double way, std::span<const RayHit> hits) const;

  const Scene& scene_;
  const slam::Pose2& T_map_robot_;
  const ViewPlannerOptions& options_;
  std::uint64_t seed_;
  const LookedAt& looked_at_;
  const WayCost& way_cost_;
};

std::vector<Eigen::Vector2d> Decision::DrawReachable() const {
  const int count = options_.candidates.count;
  if (options_.sampler != CandidateSampler::kUniform) {
    OmplCandidateOptions ompl = options_.ompl;
    ompl.count = count;
    return Reachable(DrawOmplCandidates(scene_.free, options_.robot_radius, options_.sampler, ompl, seed_),
                     count);
  }
  CandidateOptions more = options_.candidates;
  more.count *= 3;  // some keep too little distance from walls, or cannot be reached
  return DrawWantedCandidates(scene_.area, scene_.edges, more, seed_, count,
                              [&](const Eigen::Vector2d& p_map) { return IsReachable(p_map); });
}

std::vector<Eigen::Vector2d> Decision::DrawAround(const Eigen::Vector2d& center) const {
  RandomStream stream = NamedStream(seed_, "view/refine");
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < options_.refined; ++i) {
    const double radius = options_.refine_radius * std::sqrt(DrawUniform(stream, 0.0, 1.0));
    const double bearing = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
    places.push_back(center + radius * Eigen::Vector2d(std::cos(bearing), std::sin(bearing)));
  }
  return places;
}

std::vector<Eigen::Vector2d> Decision::Reachable(std::span<const Eigen::Vector2d> places, int count) const {
  std::vector<Eigen::Vector2d> reachable;
  for (const Eigen::Vector2d& p_map : places) {
    if (reachable.size() == static_cast<std::size_t>(count)) break;
    if (IsReachable(p_map)) reachable.push_back(p_map);
  }
  return reachable;
}

/// Where ways really begin: a robot that has just looked ahead stands at the edge of what it knows.
Eigen::Vector2d Decision::StartWithRoom(std::span<const Eigen::Vector2d> places) const {
  const Eigen::Vector2d& start = T_map_robot_.translation;
  if (scene_.free.IsFree(start, options_.robot_radius) || places.empty()) return start;
  const auto path = scene_.ways.PathTo(places.front());
  return path.size() > 1 ? path[1] : start;
}

std::vector<double> Decision::Ways(std::span<const Eigen::Vector2d> places) const {
  if (options_.way == WayLength::kRoadmap) {
    const Roadmap roadmap = BuildRoadmap(scene_.free, options_.robot_radius, options_.roadmap, seed_);
    return RoadmapDistances(scene_.free, roadmap, StartWithRoom(places), places);
  }
  const bool straight = options_.way == WayLength::kStraight;
  std::vector<double> ways;
  for (const Eigen::Vector2d& p_map : places) {
    ways.push_back(straight ? (p_map - T_map_robot_.translation).norm() : scene_.ways.To(p_map));
  }
  return ways;
}

/// With what is too narrow, or earlier scans have looked at in vain, as spent.
std::vector<RayHit> Decision::Cast(const Eigen::Vector2d& p_map) const {
  std::vector<RayHit> hits = scene_.gain.Cast(p_map);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!scene_.gain.IsUnseen(hits[i])) continue;
    const Eigen::Vector2d met = p_map + hits[i].distance * scene_.gain.Direction(i);
    hits[i].spent = scene_.openings[hits[i].edge] < options_.min_opening ||
                    !looked_at_.IsWorth(met, scene_.gain.Direction(i), hits[i], options_.look_again);
  }
  return hits;
}

View Decision::Look(const Eigen::Vector2d& p_map, double way, std::span<const RayHit> hits) const {
  View view =
      JudgedView(p_map, scene_.gain.Of(hits, options_.min_overlap), way, T_map_robot_, options_.view);
  if (!way_cost_) return view;
  view.distance = way_cost_(scene_.ways.PathTo(p_map), view);
  view.value = std::exp(LogValue(view, options_.view));
  return view;
}

Judged Decision::Judge(std::span<const Eigen::Vector2d> places) const {
  Judged judged;
  JudgeMore(places, judged);
  return judged;
}

void Decision::JudgeMore(std::span<const Eigen::Vector2d> places, Judged& judged) const {
  const std::vector<double> ways = Ways(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<RayHit> hits = Cast(places[i]);
    judged.views.push_back(Look(places[i], ways[i], hits));
    if (!LooksAhead(options_.policy)) continue;
    judged.pieces.push_back(PiecesOf(scene_, judged.views.back(), hits, options_.piece, judged.numbers));
  }
}

std::optional<std::size_t> Decision::Choose(const Judged& judged) const {
  ViewChoice choice{judged.views, {}, judged.pieces, {}};
  for (std::size_t i = 0; i < judged.views.size(); ++i) {
    const View& view = judged.views[i];
    const bool is_enough = view.gain >= options_.view.min_gain && view.overlap >= options_.min_overlap;
    if (is_enough && std::isfinite(view.distance)) choice.worth.push_back(i);
  }
  if (choice.worth.empty()) return {};
  choice.ways = [&](std::size_t from, std::span<const std::size_t> to) {
    const GeodesicField ways = DistancesFrom(scene_.free, judged.views[from].p_map, options_.robot_radius);
    std::vector<double> lengths;
    for (const std::size_t i : to) lengths.push_back(ways.To(judged.views[i].p_map));
    return lengths;
  };
  return ChooseView(choice, options_, seed_);
}

/// Where no scan from the robot's place has looked: the middle of the widest gap between their headings,
/// if it is so wide that not only the scans' margins lie in it [rad].
std::optional<double> HeadingNotScanned(const slam::Pose2& T_map_robot,
                                        std::span<const slam::Pose2> T_map_scans, double field_of_view) {
  std::vector<double> turns;  // from the robot's heading, [0, 2 pi)
  for (const slam::Pose2& T_map_scan : T_map_scans) {
    if ((T_map_scan.translation - T_map_robot.translation).norm() > kSamePlaceAsRobot) continue;
    const double turn = slam::WrapAngle(T_map_scan.angle - T_map_robot.angle);
    turns.push_back(turn < 0.0 ? turn + kFullTurn : turn);
  }
  if (turns.empty() || field_of_view >= kFullTurn) return {};
  std::ranges::sort(turns);
  double widest = 0.0, middle = 0.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double next = i + 1 < turns.size() ? turns[i + 1] : turns.front() + kFullTurn;
    if (next - turns[i] <= widest) continue;
    widest = next - turns[i];
    middle = 0.5 * (next + turns[i]);
  }
  if (turns.size() > 1 && widest <= kOverlappingGap * field_of_view) return {};
  return slam::WrapAngle(T_map_robot.angle + middle);
}

View TurnInPlace(const slam::Pose2& T_map_robot, double direction) {
  View view;
  view.p_map = T_map_robot.translation;
  view.direction = direction;
  view.turn = std::abs(slam::WrapAngle(direction - T_map_robot.angle));
  return view;
}

}  // namespace

ViewPlannerOptions PaperViewPlannerOptions() {
  ViewPlannerOptions options;
  options.policy = ViewPolicy::kExponential;
  options.way = WayLength::kStraight;
  options.second_look = 0;
  options.look_again = 1000.0;
  options.refined = 0;
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
                      const ViewPlannerOptions& options, std::uint64_t seed,
                      std::span<const slam::Pose2> T_map_scans, const WayCost& way_cost,
                      std::span<const Eigen::Vector2d> obstacles_map) {
  CheckOptions(options, "planner.");
  const Scene scene(area, T_map_robot, options, obstacles_map);
  const LookedAt looked_at(scene.edges, T_map_scans, options.view.gain, options.piece);
  const Decision decision(scene, T_map_robot, options, seed, looked_at, way_cost);
  const bool by_frontier = options.policy == ViewPolicy::kNearestFrontier;
  ViewPlan plan;
  Judged judged;
  if (!by_frontier) {
    judged = decision.Judge(decision.DrawReachable());
    plan.chosen = decision.Choose(judged);
    if (plan.chosen && options.refined > 0 && options.policy != ViewPolicy::kRandom) {
      const auto around = decision.DrawAround(judged.views[*plan.chosen].p_map);
      decision.JudgeMore(decision.Reachable(around, options.refined), judged);
      plan.chosen = decision.Choose(judged);
    }
  }
  for (const FrontierSide side : {FrontierSide::kBefore, FrontierSide::kAside}) {
    if (plan.chosen || !(by_frontier || options.second_look > 0)) break;
    plan.second_look = !by_frontier;
    const auto places = FrontierPlaces(scene.edges, scene.free, ViewClearance(options), side);
    const int count = by_frontier ? options.candidates.count : options.second_look;
    Judged before_edges = decision.Judge(decision.Reachable(places, count));
    plan.chosen = decision.Choose(before_edges);
    if (plan.chosen || judged.views.empty()) judged = std::move(before_edges);
  }
  plan.views = std::move(judged.views);
  if (plan.views.empty() && options.second_look > 0) {
    const double field_of_view = slam::RadFromDeg(options.view.gain.field_of_view);
    if (const auto direction = HeadingNotScanned(T_map_robot, T_map_scans, field_of_view)) {
      plan.views.push_back(TurnInPlace(T_map_robot, *direction));
      plan.chosen = 0;
      plan.path_map = {T_map_robot.translation};
    }
  }
  if (!plan.views.empty()) plan.status = plan.chosen ? NextViewStatus::kFound : NextViewStatus::kNoGain;
  if (plan.chosen && plan.path_map.empty()) {
    plan.path_map = scene.ways.PathTo(plan.views[*plan.chosen].p_map);
  }
  return plan;
}

}  // namespace ariadne::planning
