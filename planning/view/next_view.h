#pragma once

#include <array>
#include <optional>

#include "planning/view/ray_gain.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

/// V(p) exp(-c1 ||r - p||) exp(-c2 |theta_r - theta_p|), Sec. 4.2 step 6, times the share of what there is
/// to see around p that the view shows. The defaults are calibrated; the paper's are PaperNextViewOptions.
struct NextViewOptions {
  double distance_weight = 0.1;
  double angle_weight = 0.0;
  double rest_weight = 1.0;
  int min_gain = 5;
  RayGainOptions gain = {.measure = GainMeasure::kArea};

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("distance_weight", self.distance_weight, Unit("1/m"), Range{0.0, 1000.0},
          "c1; 0.1 weighs over 10 m. The paper's 0.05 per cm is 5, with which no candidate 1.04 m farther "
          "can win "
          "against one that has a single ray");
    visit(
        "angle_weight", self.angle_weight, Unit("1/deg"), Range{0.0, 10.0},
        "c2; the paper's 0.01 has an effect only in degrees: turning about costs a factor 0.17. 0: a turn "
        "takes seconds, a scan more");
    visit("rest_weight", self.rest_weight, Unit(""), Range{0.0, 100.0},
          "exponent of the share of the gain in all directions that the view shows: from a place in the "
          "middle of "
          "what is unknown the rest needs a second scan, from its edge often none. The paper has none (0)");
    visit("min_gain", self.min_gain, Unit("rays"), Range{1, 36001},
          "views with less are not worth a stop, and where all have less, exploration ends; the paper "
          "has no rule. 5 rays of 1 deg are the robot's width, 0.6 m, in a distance of 7 m");
    visit("gain", self.gain, "the scanner that views are judged by");
  }
};

/// The constants as they are printed, and any ray counts: preset `paper`.
NextViewOptions PaperNextViewOptions();

/// A candidate and what speaks for it.
struct View {
  Eigen::Vector2d p_map = Eigen::Vector2d::Zero();
  double direction = 0.0;  // of the scanner's middle, in the map [rad], (-pi, pi]
  int gain = 0;            // rays
  double area = 0.0;       // that may be found behind what these rays meet [m^2]
  double shown = 1.0;      // share of the gain in all directions from there
  double overlap = 0.0;    // share of the rays that meet what is known: what registration has to go by
  double distance = 0.0;   // of the way from the robot; infinite: there is none [m]
  double turn = 0.0;       // between the robot's heading and the direction [rad], [0, pi]
  double value = 0.0;      // may underflow to 0 far away; the choice is made by its logarithm
};

enum class NextViewStatus { kFound, kNoGain, kNoCandidates };

struct NextViewResult {
  NextViewStatus status = NextViewStatus::kNoCandidates;
  std::vector<View> views;            // all candidates, in their order
  std::optional<std::size_t> chosen;  // of the views, where one was found
};

/// The gain by its measure: rays, or an area [m^2].
double GainOf(const View& view, const NextViewOptions& options);

/// The logarithm of the value: of the gain by its measure, and of all penalties.
double LogValue(const View& view, const NextViewOptions& options);

/// A place with its best field of view, seen from where the robot is; `way` is the distance to it [m].
View JudgedView(const Eigen::Vector2d& p_map, const ViewGain& best, double way,
                const slam::Pose2& T_map_robot, const NextViewOptions& options);

/// The candidate with the highest value among those with min_gain; of equal ones the first. kNoGain:
/// nothing is left to see from any candidate. Error for a pose, candidates or edges that are not finite.
NextViewResult ChooseNextView(std::span<const Eigen::Vector2d> candidates, std::span<const Edge> edges,
                              const slam::Pose2& T_map_robot, const NextViewOptions& options);

}  // namespace ariadne::planning

namespace ariadne {

template <>
struct EnumNames<planning::NextViewStatus> {
  static constexpr std::array<std::string_view, 3> value{"found", "no_gain", "no_candidates"};
};

}  // namespace ariadne
