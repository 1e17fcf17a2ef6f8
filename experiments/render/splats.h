#pragma once

#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/colored_points.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// How points are drawn: as discs of their colour that face the camera.
struct SplatOptions {
  double radius = 0.0;
  double noise = 0.02;
  double min_radius = 0.6;
  double max_radius = 8.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("radius", self.radius, Unit("m"), Range{0.0, 10.0},
          "of a disc in the map; 0: from the density of the points, so that surfaces close");
    visit("noise", self.noise, Unit("m"), Range{0.0, 10.0},
          "of the points along the view: what blends, and what shading ignores");
    visit("min_radius", self.min_radius, Unit("px"), Range{0.1, 100.0},
          "of a disc in the picture, so that far points remain visible");
    visit("max_radius", self.max_radius, Unit("px"), Range{0.1, 100.0},
          "of a disc in the picture, so that points just before the camera do not cover all");
  }
};

/// A point as it appears in a picture.
struct Splat {
  float u = 0.0F;       // [px]
  float v = 0.0F;       // [px]
  float depth = 0.0F;   // [m]
  float radius = 0.0F;  // [px]
  float grain = 0.0F;   // uncertainty of the depth, from the size of the disc and the noise [m]
  Rgb color;
};

/// The points that are in front of the camera and touch the picture.
std::vector<Splat> ProjectSplats(const ColoredPoints& points, const Camera& camera,
                                 const SplatOptions& options);

}  // namespace ariadne::experiments
