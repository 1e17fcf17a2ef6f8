#pragma once

#include "experiments/render/frame.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// Shading by differences of depth, after eye-dome lighting (Boucheny 2009): a pixel is darker the further
/// it lies behind its surroundings. It needs no normals and no lights, and draws the edges of things. Other
/// than there, a pixel is compared with the middle between opposite neighbours, so that a plane keeps its
/// colour however it is tilted; and steps below the frame's grain count nothing, so that points do not show
/// singly.
struct EyeDomeOptions {
  double strength = 1.0;
  double radius = 2.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("strength", self.strength, Unit(""), Range{0.0, 10.0}, "0 is off, 3 makes black outlines");
    visit("radius", self.radius, Unit("px"), Range{1.0, 50.0},
          "from a pixel to its neighbours: width of the outlines");
  }
};

/// Darkens the covered pixels of the frame; the background stays as it is.
void ShadeEyeDome(Frame& frame, const Camera& camera, const EyeDomeOptions& options);

}  // namespace ariadne::experiments
