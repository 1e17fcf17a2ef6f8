#pragma once

#include "experiments/render/camera.h"
#include "experiments/render/colored_points.h"
#include "experiments/render/image.h"
#include "experiments/render/paper.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// How ink becomes darkness. With s = ink / (ink of the reference pixel), the optical density of a pixel is
/// log(1 + contrast * s) / log(1 + contrast), at most `darkest`: density 0 is paper, 1 the ink's own
/// colour.
struct DensityOptions {
  double column = 0.1;
  double pen_radius = 1.0;
  double reference_share = 0.99;
  double contrast = 8.0;
  double darkest = 1.4;
  Rgb background = kWhite;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("column", self.column, Unit("m"), Range{0.0, 10.0},
          "side of the columns whose height is shown, near the thickness of walls; 0: all points count "
          "alike");
    visit("pen_radius", self.pen_radius, Unit("px"), Range{1.0, Paper::kLargestPen},
          "of the tent-shaped drop of a point; 1 spreads it bilinearly, more makes lines thicker");
    visit("reference_share", self.reference_share, Unit(""), Range{0.0, 1.0},
          "percentile of the inked pixels that gets density 1; below 1 because single pixels stick out");
    visit("contrast", self.contrast, Unit(""), Range{1e-3, 1e6},
          "towards 0 density is proportional to ink; larger shows faint walls beside strong ones");
    visit("darkest", self.darkest, Unit(""), Range{0.0, 10.0},
          "highest density; above 1 it is darker than the colour of the points");
  }
};

/// Registered scans as ink on paper, for orthographic cameras and mostly for top views: every point drops
/// ink of its colour, and what stands upright (walls) becomes dark lines. Whether a wall is single or
/// double is seen at once. Nothing hides anything.
Image RenderDensity(const ColoredPoints& points, const Camera& camera, const DensityOptions& options = {});

}  // namespace ariadne::experiments
