#pragma once

#include <Eigen/Geometry>
#include <string>

#include "experiments/report/viewer_scene.h"

namespace ariadne::experiments {

/// What there was before thinning, and the edges of its cubes; 0: nothing was thinned [m].
struct ViewerCounts {
  std::size_t points = 0;
  std::size_t triangles = 0;
  double point_spacing = 0.0;
  double mesh_spacing = 0.0;
};

/// All of a thinned scene but its arrays, as JSON that may stand within HTML; and the colours that the
/// pictures of a run have. `box` is that of the arrays.
std::string HeaderOf(const ViewerScene& scene, const Eigen::AlignedBox3d& box, const ViewerCounts& counts);

}  // namespace ariadne::experiments
