#include "experiments/render/point_view.h"

#include "experiments/render/draw_splats.h"

namespace ariadne::experiments {
namespace {

/// Lengths in pixels of a picture that is larger by a factor.
SplatOptions Magnified(SplatOptions options, int factor) {
  options.min_radius *= factor;
  options.max_radius *= factor;
  return options;
}

EyeDomeOptions Magnified(EyeDomeOptions options, int factor) {
  options.radius *= factor;
  return options;
}

}  // namespace

Image RenderPoints(const ColoredPoints& points, const Camera& camera, const PointViewOptions& options) {
  CheckOptions(options, "view: ");
  const int factor = options.supersampling;
  const Camera magnified = Magnified(camera, factor);
  Frame frame(magnified, options.background);
  DrawSplats(frame, ProjectSplats(points, magnified, Magnified(options.splats, factor)));
  ShadeEyeDome(frame, magnified, Magnified(options.eye_dome, factor));
  return Reduced(frame.color, factor);
}

}  // namespace ariadne::experiments
