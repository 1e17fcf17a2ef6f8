#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/render/image.h"

namespace ariadne::experiments {

/// A pose graph as it is drawn.
struct DrawnGraph {
  struct Edge {
    std::size_t from = 0;  // indices of positions
    std::size_t to = 0;
    bool closure = false;
    double weight = 1.0;  // what a robust kernel has left of it, 0 (nothing) to 1
  };
  std::vector<Edge> edges;
  bool planar = false;  // drawn from above; else at an angle
};

/// Vertices of a graph before and after side by side, each as large as it fits with its scale below. Both
/// are seen from the same side, which is chosen by the shape after: across its longest extent.
Image GraphPicture(const DrawnGraph& graph, const std::vector<Eigen::Vector3d>& before_map,
                   const std::vector<Eigen::Vector3d>& after_map, const std::string& title_before,
                   const std::string& title_after);

}  // namespace ariadne::experiments
