#include "experiments/render/density_view.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "experiments/render/column_ink.h"
#include "experiments/render/paper.h"
#include "experiments/render/percentile.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

Paper Inked(const ColoredPoints& points, const Camera& camera, const DensityOptions& options) {
  const Projector project(camera);
  std::vector<ImagePoint> projected;
  projected.reserve(points.positions_map.size());
  for (const Eigen::Vector3d& p_map : points.positions_map) projected.push_back(project(p_map));
  const std::vector<float> ink = options.column > 0.0 ? ColumnInk(projected, camera, options.column)
                                                      : std::vector<float>(projected.size(), 1.0F);
  Paper paper(camera.width, camera.height);
  for (std::size_t i = 0; i < projected.size(); ++i) {
    paper.Drop(projected[i], ink[i], points.colors[i], options.pen_radius);
  }
  return paper;
}

/// The amount of ink that becomes density 1.
float ReferenceInk(const std::vector<Ink>& ink, double share) {
  std::vector<float> amounts;
  for (const Ink& pixel : ink) {
    if (pixel[0] > 0.0F) amounts.push_back(pixel[0]);
  }
  return amounts.empty() ? 1.0F : Percentile(std::move(amounts), share);
}

/// Paper seen through ink: light of each channel is dimmed exponentially with the density (Beer's law),
/// so that thin ink is a tint, density 1 the ink's own colour, and more is deeper.
Rgb Seen(const Ink& ink, double density, Rgb background) {
  const auto channel = [&](float sum, std::uint8_t paper) {
    const double transmittance = std::max(static_cast<double>(sum / ink[0]) / 255.0, 0.03);
    return ToChannel(paper * std::pow(transmittance, density));
  };
  return {channel(ink[1], background.r), channel(ink[2], background.g), channel(ink[3], background.b)};
}

}  // namespace

Image RenderDensity(const ColoredPoints& points, const Camera& camera, const DensityOptions& options) {
  RequireDrawable(points);
  CheckOptions(options, "density view: ");
  if (camera.projection != Camera::Projection::kOrthographic) {
    Fail("a density view needs an orthographic camera, e.g. a top view");
  }
  Image image(camera.width, camera.height, options.background);
  const Paper paper = Inked(points, camera, options);
  const float reference = ReferenceInk(paper.ink(), options.reference_share);
  const double gain = options.contrast / reference;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Ink& ink = paper.ink()[i];
    if (ink[0] <= 0.0F) continue;
    const double density = std::log1p(gain * ink[0]) / std::log1p(options.contrast);
    image.pixels[i] = Seen(ink, std::min(density, options.darkest), options.background);
  }
  return image;
}

}  // namespace ariadne::experiments
