#pragma once

#include "experiments/render/camera.h"
#include "experiments/render/colored_points.h"
#include "experiments/render/eye_dome.h"
#include "experiments/render/image.h"
#include "experiments/render/splats.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

struct PointViewOptions {
  SplatOptions splats = {};
  EyeDomeOptions eye_dome = {};
  Rgb background = kWhite;
  int supersampling = 2;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("splats", self.splats, "how points are drawn");
    visit("eye_dome", self.eye_dome, "shading");
    visit("supersampling", self.supersampling, Unit(""), Range{1, 4},
          "the picture is drawn this many times larger and then reduced, against jagged edges");
  }
};

/// A perspective or oblique picture of points with hidden ones removed. Lengths in pixels count in the
/// finished picture, whatever the supersampling.
Image RenderPoints(const ColoredPoints& points, const Camera& camera, const PointViewOptions& options = {});

}  // namespace ariadne::experiments
