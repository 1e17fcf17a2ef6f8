#include "experiments/render/scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct ScaleBar {
  double length_px = 0.0;
  std::string label;
};

ScaleBar ScaleBarFor(const Image& picture, const Camera& camera) {
  RequireUsable(camera);
  if (camera.projection != Camera::Projection::kOrthographic) {
    Fail("a perspective picture has no scale: a scale bar needs an orthographic camera");
  }
  const double length = RoundNumberBelow(0.25 * picture.width / camera.scale);  // [m]
  return {length * camera.scale,
          length < 1.0 ? fmt::format("{:.3g} cm", 100.0 * length) : fmt::format("{:.6g} m", length)};
}

/// The bar with its left end and the middle of its height at `left`, its label to the right.
void DrawBar(Image& canvas, const Eigen::Vector2d& left, const ScaleBar& bar, const TextStyle& style) {
  const Eigen::Vector2d right = left + Eigen::Vector2d(bar.length_px, 0.0);
  const Eigen::Vector2d tick(0.0, 0.5 * style.cap_height);
  DrawPolylines(canvas, {{left - tick, left + tick}, {left, right}, {right - tick, right + tick}},
                {.color = style.color, .width = std::max(1.5, 0.16 * style.cap_height)});
  DrawText(canvas, right + Eigen::Vector2d(0.8 * style.cap_height, 0.5 * style.cap_height), bar.label,
           style);
}

/// So many that a hundredth of the range shows.
int DecimalsFor(const ValueRange& range) {
  const double span = std::abs(range.high - range.low);
  return span > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 9) : 3;
}

}  // namespace

double RoundNumberBelow(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) Fail("there is no round number below {}", value);
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power * (1.0 + 1e-9);
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

Image WithScaleBar(const Image& picture, const Camera& camera, const AnnotationOptions& options) {
  const TextStyle style = AnnotationText(picture, options);
  Image band(picture.width, static_cast<int>(std::lround(2.4 * style.cap_height)), options.background);
  DrawBar(band, {0.8 * style.cap_height, 0.5 * band.height}, ScaleBarFor(picture, camera), style);
  return Stacked(picture, band);
}

void DrawScaleBar(Image& canvas, const Camera& camera, const AnnotationOptions& options) {
  const TextStyle style = AnnotationText(canvas, options);
  const ScaleBar bar = ScaleBarFor(canvas, camera);
  const double unit = style.cap_height;
  const Eigen::Vector2d corner(0.0, canvas.height);
  const double width = bar.length_px + TextWidth(bar.label, style) + 2.4 * unit;
  FillRectangle(canvas, corner, corner + Eigen::Vector2d(width, -2.4 * unit), options.background, 0.85);
  DrawBar(canvas, corner + Eigen::Vector2d(0.8 * unit, -1.2 * unit), bar, style);
}

Image WithColorBar(const Image& picture, ColorMap map, const ValueRange& range, std::string_view quantity,
                   const AnnotationOptions& options) {
  const TextStyle style = AnnotationText(picture, options);
  const double unit = style.cap_height;
  Image band(picture.width, static_cast<int>(std::lround(4.2 * unit)), options.background);
  const double left = 0.1 * picture.width;
  const double right = 0.6 * picture.width;
  for (int x = static_cast<int>(left); x < static_cast<int>(right); ++x) {
    FillRectangle(band, {x, 0.6 * unit}, {x + 1.0, 1.8 * unit},
                  ColorAt(map, (x + 0.5 - left) / (right - left)));
  }
  const double baseline = 3.4 * unit;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double value = range.low + share * (range.high - range.low);
    const double unit_of_label = std::pow(10.0, -DecimalsFor(range));
    const double rounded = std::round(value / unit_of_label) * unit_of_label + 0.0;  // -0 + 0 is 0
    const std::string label = fmt::format("{:.{}f}", rounded, DecimalsFor(range));
    DrawText(band, {left + share * (right - left), baseline}, label, style, Align::kCenter);
  }
  TextStyle name = style;
  name.cap_height *=
      std::min(1.0, (0.38 * picture.width - unit) / std::max(1.0, TextWidth(quantity, style)));
  DrawText(band, {right + unit, 1.2 * unit + 0.5 * name.cap_height}, quantity, name);
  return Stacked(picture, band);
}

}  // namespace ariadne::experiments
