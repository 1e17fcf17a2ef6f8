#pragma once

#include "control/simulate_approach.h"

namespace ariadne::control {

/// How dense poses of a trajectory are tested for collisions.
struct PathSampling {
  double per_meter = 10.0;
  double per_radian = 10.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("per_meter", self.per_meter, Unit("1/m"), Range{1.0, 1e4}, "Sec. 5.2");
    visit("per_radian", self.per_radian, Unit("1/rad"), Range{0.0, 1e4},
          "of turns; 0.1 rad move a corner 5 cm. The paper has none (0), and would miss turns in place");
  }
};

/// Poses along a trajectory so that per_meter times the way plus per_radian times the turn between two is
/// at most 1: evenly, on its arcs, start and end included. A trajectory without motion is one pose.
std::vector<slam::Pose2> ResamplePath(const std::vector<ApproachSample>& samples,
                                      const PathSampling& sampling);

}  // namespace ariadne::control
