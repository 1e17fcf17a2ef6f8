#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/render/camera.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

struct FitOptions {
  double outlier_share = 0.002;
  int margin = 40;
  bool adjust_height = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("outlier_share", self.outlier_share, Unit(""), Range{0.0, 0.4},
          "of the points that may fall outside on each side; 0 shows all");
    visit("margin", self.margin, Unit("px"), Range{0, 10000}, "that stays free on each side");
    visit("adjust_height", self.adjust_height,
          "cut the picture's height to what its content needs at full width");
  }
};

/// The camera moved (and for orthographic ones scaled), without being turned, so that the points fill the
/// picture. A few stray points do not shrink it: each side of the picture is set by a percentile. Without
/// points the camera stays as it is.
Camera Fitted(const Camera& camera, const std::vector<Eigen::Vector3d>& positions_map,
              const FitOptions& options = {});

}  // namespace ariadne::experiments
