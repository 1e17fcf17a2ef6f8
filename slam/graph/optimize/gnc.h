#pragma once

#include "slam/graph/optimize/descend.h"

namespace ariadne::slam {

/// Graduated non-convexity with truncated least squares (Yang, Antonante, Tzoumas, Carlone, RA-L 2020):
/// closures whose squared error is above `squared_scale` should not count at all. It starts from a convex
/// problem, in which all of them count a little, and approaches the truncated one; each round weighs the
/// closures by their errors and descends. Edges between successive nodes always count fully.
struct GncOutcome {
  DescentOutcome descent;
  std::vector<double> weights;  // one per edge, in [0, 1]
  int rounds = 0;
};

template <typename Pose>
GncOutcome DescendGraduated(PoseGraph<Pose>& graph, Descent<Pose>& descent, double squared_scale,
                            const GraphOptions& options,
                            const std::function<void(const GraphIteration&)>& on_iteration);

}  // namespace ariadne::slam
