#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "planning/view/edge_set.h"
#include "planning/view/sliding_window.h"
#include "slam/base/options.h"

namespace ariadne::planning {

/// What a ray that meets an unseen edge counts.
enum class GainMeasure {
  kRays,  // one (the paper's)
  kArea,  // the sector behind the edge, up to a depth or the range: what may be found there
};

/// The horizontal scanner that a view is judged by (Sec. 4.2 step 5).
struct RayGainOptions {
  GainMeasure measure = GainMeasure::kRays;
  double depth = 5.0;
  bool until_known = false;
  int rays = 360;
  double field_of_view = 180.0;
  double min_range = 0.5;
  double max_range = 15.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("measure", self.measure,
          "what a ray to an unseen edge counts: rays is the paper's 1 (4.2), area the sector behind it "
          "(after Gonzalez-Banos and Latombe 2002)");
    visit("depth", self.depth, Unit("m"), Range{0.1, 1000.0},
          "behind an unseen edge, of that sector; a room's");
    visit("until_known", self.until_known,
          "whether that sector ends where its ray comes back to what is known; the gaps that the robot has "
          "just passed then wait, and cost a tenth more way later");
    visit("rays", self.rays, Unit("1/turn"), Range{4, 36000},
          "around a place; the paper leaves the step open, 360 is the sensor's 1 deg");
    visit("field_of_view", self.field_of_view, Unit("deg"), Range{0.0, 360.0},
          "of a view, both end rays included: 181 rays at 1 deg");
    visit("min_range", self.min_range, Unit("m"), Range{0.0, 100.0},
          "nearer hits count nothing and still block the ray; 0.5 is the paper's, 0 lets all hits count");
    visit("max_range", self.max_range, Unit("m"), Range{0.01, 10000.0},
          "farther hits, and rays without a hit, count nothing; the paper's 15, less in slices whose "
          "height the tilt reaches only near the robot");
  }
};

/// What a ray meets first.
struct RayHit {
  double distance = std::numeric_limits<double>::infinity();  // [m]; beyond max_range it may be any
  bool seen = false;                                          // the label of the edge
  bool spent = false;    // whether an unseen edge has nothing more to give
  std::size_t edge = 0;  // its number, where there is a hit
  double beyond = std::numeric_limits<double>::infinity();  // distance of the next edge behind [m]
};

/// The best field of view of a place.
struct ViewGain {
  int gain = 0;            // V(p): its rays that meet an unseen edge
  double area = 0.0;       // behind those edges, up to the depth [m^2]
  double shown = 1.0;      // share of what all directions together would show, by the measure
  double overlap = 0.0;    // share of its rays that meet a seen edge within range
  double direction = 0.0;  // theta_p, of its middle, in the map [rad], (-pi, pi]
};

/// Rays from any place to one set of edges. Ray 0 points along `heading`, the others follow
/// counterclockwise: with the robot's heading, no result depends on the frame of the map.
class RayGain {
 public:
  /// The edges must outlive this. Error for edges or a heading that are not finite.
  RayGain(std::span<const Edge> edges, double heading, const RayGainOptions& options);

  /// The nearest hit of each ray. An edge is projected onto the rays that it spans, which costs
  /// O(edges + hits). Where hits coincide, seen wins. An edge is open at one end, so that no ray slips
  /// through where two edges meet; a ray along an edge meets its neighbour. A place on an edge sees that.
  std::vector<RayHit> Cast(const Eigen::Vector2d& p_map) const;

  /// f(p, i): whether a ray meets an unseen edge within the range limits, which is not spent.
  bool IsUnseen(const RayHit& hit) const;

  /// What a ray that meets an unseen edge counts: 1, or an area [m^2].
  double GainOf(const RayHit& hit) const;

  /// V(p) and theta_p. Ties as in BestWindow, value 0 being the heading.
  ViewGain At(const Eigen::Vector2d& p_map) const;

  /// The same of rays that have been cast. Where the direction with the largest gain has less overlap than
  /// `min_overlap`, the best of those that have it, if any has.
  ViewGain Of(std::span<const RayHit> hits, double min_overlap = 0.0) const;

  /// The numbers of the rays within the field of view about a direction in the map.
  std::vector<std::size_t> RaysAbout(double direction) const;

  /// Of a ray, of length 1, in the map.
  const Eigen::Vector2d& Direction(std::size_t ray) const { return direction_[ray]; }

 private:
  bool IsKnown(const RayHit& hit) const { return hit.seen && hit.distance <= options_.max_range; }
  ViewGain About(const Window& window, std::span<const RayHit> hits) const;
  void AddCorner(const Eigen::Vector2d& p_map);
  double AreaBehind(const RayHit& hit) const;
  double GainAllAround(std::span<const RayHit> hits) const;
  void Project(std::size_t edge, const Eigen::Vector2d& a, const Eigen::Vector2d& b, int first, int count,
               std::span<RayHit> hits) const;
  void Meet(std::size_t edge, double distance, RayHit& hit) const;

  std::span<const Edge> edges_;
  double heading_;  // [rad]
  RayGainOptions options_;
  double step_;                              // between rays [rad]
  std::vector<Eigen::Vector2d> direction_;   // of each ray, of length 1
  std::vector<double> corner_x_, corner_y_;  // of the edges, each right after the one before it [m]
  std::vector<std::size_t> corner_to_;       // where each edge ends
};

}  // namespace ariadne::planning

namespace ariadne {

template <>
struct EnumNames<planning::GainMeasure> {
  static constexpr std::array<std::string_view, 2> value{"rays", "area"};
};

}  // namespace ariadne
