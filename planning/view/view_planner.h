#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "planning/path/free_space.h"
#include "planning/path/roadmap.h"
#include "planning/polygon/labelled_polygon.h"
#include "planning/view/next_view.h"
#include "planning/view/ompl_candidates.h"
#include "planning/view/uniform_candidates.h"

namespace ariadne::planning {

/// How one of the candidates is chosen.
enum class ViewPolicy {
  kExponential,      // gain exp(-c1 way) exp(-c2 turn), Sec. 4.2 step 6
  kGain,             // the largest gain, wherever it is
  kRandom,           // any with enough gain
  kNearestFrontier,  // of the places before unseen edges the nearest (Yamauchi 1997)
  kPotentialArea,    // area behind unseen edges times exp(-way / 5 m) (Gonzalez-Banos, Latombe 2002)
  kTwoSteps,         // the first of the pair that shows most per way
};

enum class WayLength {
  kStraight,  // the paper's ||r - p||
  kGeodesic,  // of the shortest way of a disc through what is known to be free
  kRoadmap,   // of the way through a roadmap of OMPL (PRM*)
};

/// The length of the way to a view [m], instead of WayLength: corners from the robot's place on, and the
/// view.
using WayCost = std::function<double(std::span<const Eigen::Vector2d> path_map, const View& view)>;

struct ViewPlannerOptions {
  ViewPolicy policy = ViewPolicy::kExponential;
  WayLength way = WayLength::kGeodesic;
  double robot_radius = 0.3;
  double view_clearance = 0.0;
  double min_overlap = 0.0;
  double least_share = 0.0;
  int second_look = 1000;
  double piece = 0.5;
  double look_again = 0.5;
  double min_opening = 0.0;
  int refined = 200;
  double refine_radius = 3.0;
  FreeSpaceOptions free_space;
  CandidateSampler sampler = CandidateSampler::kUniform;
  CandidateOptions candidates;
  OmplCandidateOptions ompl;
  RoadmapOptions roadmap;
  NextViewOptions view;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("policy", self.policy, "how one of the candidates is chosen; exponential is the paper's (4.2)");
    visit("way", self.way, "what the distance to a candidate is; straight is the paper's");
    visit("robot_radius", self.robot_radius, Unit("m"), Range{0.05, 5.0},
          "of the disc that must get to a candidate: half the robot's width, since it passes doors "
          "lengthwise");
    visit("view_clearance", self.view_clearance, Unit("m"), Range{0.0, 5.0},
          "from a view to what is in the way, where robot_radius is less: half the robot's diagonal and "
          "some more, so that it can turn there to any side");
    visit("min_overlap", self.min_overlap, Unit("share"), Range{0.0, 1.0},
          "of a view's rays that must meet known walls, so that it can be registered: a place looks where "
          "it gains most among the directions that have it; the paper has no such rule (0)");
    visit("least_share", self.least_share, Unit("share"), Range{0.0, 1.0},
          "of the largest gain of all candidates, below which policy exponential leaves a view for later: "
          "the "
          "little that is left behind is often seen from elsewhere, or else costs the way back. The paper "
          "has no such rule (0)");
    visit("second_look", self.second_look, Unit(""), Range{0, 1000000},
          "places before unseen edges that are looked at, at most, before exploration ends; 0: it ends "
          "where no candidate has enough gain");
    visit("piece", self.piece, Unit("m"), Range{0.01, 10.0},
          "of an unseen edge, that has been looked at or not");
    visit("look_again", self.look_again, Unit("share"), Range{0.0, 1000.0},
          "of the distance from which a scan has looked at an unseen edge in vain: only from nearer than "
          "that "
          "it counts again. Windows and halls wider than the range promise the same gain for ever; 1000: "
          "always, as the paper has no such rule");
    visit(
        "min_opening", self.min_opening, Unit("m"), Range{0.0, 100.0},
        "length of unseen edges in a row, below which they do not count: the side of a door frame, or what "
        "noise leaves of a wall. The paper has no such rule (0)");
    visit("refined", self.refined, Unit(""), Range{0, 100000},
          "further candidates around the chosen one, of which the best is taken: a step to the side in a "
          "doorway shows a whole room. The paper has none (0)");
    visit("refine_radius", self.refine_radius, Unit("m"), Range{0.01, 100.0}, "around the chosen one");
    visit("free_space", self.free_space, "the raster on which ways are found");
    visit("sampler", self.sampler,
          "where candidates come from; uniform is the paper's, the others are OMPL's");
    visit("candidates", self.candidates, "places that are judged");
    visit("ompl", self.ompl, "those of OMPL's samplers; their count is that of candidates");
    visit("roadmap", self.roadmap, "for ways by roadmap");
    visit("view", self.view, "the gain and the weights");
  }
};

/// What the paper does, to the letter.
ViewPlannerOptions PaperViewPlannerOptions();

struct ViewPlan {
  NextViewStatus status = NextViewStatus::kNoCandidates;
  std::vector<View> views;                // all candidates that can be reached
  std::optional<std::size_t> chosen;      // of the views
  std::vector<Eigen::Vector2d> path_map;  // corners of the way to it, from the robot's place on
  bool second_look = false;               // whether only a place before an unseen edge was worth it
};

/// Where to scan next, given what is known to be free and which of its edges are unseen (Sec. 4.2, 4.3).
/// `T_map_scans` are the scans that have been taken, for look_again. Obstacles are in the way of the robot,
/// but not of its view. The same input gives the same bytes. Error for corners or a pose that are not
/// finite.
///
/// kNoGain, the end of an exploration: neither a candidate nor a place before an unseen edge that the
/// robot can reach has min_gain rays (and min_overlap). kNoCandidates: the robot cannot move, and has
/// scanned to all sides; before that, close before a wall, it turns to where no scan has looked.
ViewPlan PlanNextView(std::span<const LabelledPolygon> area, const slam::Pose2& T_map_robot,
                      const ViewPlannerOptions& options, std::uint64_t seed,
                      std::span<const slam::Pose2> T_map_scans = {}, const WayCost& way_cost = {},
                      std::span<const Eigen::Vector2d> obstacles_map = {});

/// All edges with their labels.
std::vector<Edge> EdgesOf(std::span<const LabelledPolygon> area);

}  // namespace ariadne::planning

namespace ariadne {

template <>
struct EnumNames<planning::ViewPolicy> {
  static constexpr std::array<std::string_view, 6> value{"exponential",      "gain",           "random",
                                                         "nearest_frontier", "potential_area", "two_steps"};
};

template <>
struct EnumNames<planning::WayLength> {
  static constexpr std::array<std::string_view, 3> value{"straight", "geodesic", "roadmap"};
};

}  // namespace ariadne
