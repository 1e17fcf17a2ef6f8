#include "experiments/render/annotations.h"

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// Lengths of the layout as multiples of the letters' height.
constexpr double kLinePitch = 2.0;
constexpr double kMargin = 0.8;
constexpr double kSwatch = 1.2;
constexpr double kSwatchGap = 0.5;
constexpr double kEntryGap = 1.6;

Image Band(const Image& picture, double height, const AnnotationOptions& options) {
  return {picture.width, std::max(1, static_cast<int>(std::lround(height))), options.background};
}

/// A band with one line, made smaller until it fits.
Image TextBand(const Image& picture, std::string_view text, TextStyle style,
               const AnnotationOptions& options) {
  const double room = picture.width - 2.0 * kMargin * style.cap_height;
  const double height = (kLinePitch + 0.4) * style.cap_height;  // tails reach a third of a letter down
  Image band = Band(picture, height, options);
  style.cap_height *= std::min(1.0, room / std::max(1.0, TextWidth(text, style)));
  DrawText(band, {0.5 * picture.width, 0.5 * (height + style.cap_height)}, text, style, Align::kCenter);
  return band;
}

/// From entry to entry, so that all stand in columns. [px]
double ColumnPitch(const std::vector<LegendEntry>& entries, const TextStyle& style) {
  double widest = 0.0;
  for (const LegendEntry& entry : entries) widest = std::max(widest, TextWidth(entry.label, style));
  return (kSwatch + kSwatchGap + kEntryGap) * style.cap_height + widest;
}

/// `place` is the left end of the entry's baseline. [px]
void DrawEntry(Image& band, const Eigen::Vector2d& place, const LegendEntry& entry,
               const TextStyle& style) {
  const double size = kSwatch * style.cap_height;
  const Eigen::Vector2d corner = place - Eigen::Vector2d(0.0, 0.5 * (style.cap_height + size));
  FillRectangle(band, corner, corner + Eigen::Vector2d(size, size), entry.color);
  DrawText(band, place + Eigen::Vector2d(size + kSwatchGap * style.cap_height, 0.0), entry.label, style);
}

}  // namespace

TextStyle AnnotationText(const Image& picture, const AnnotationOptions& options) {
  if (picture.pixels.empty()) Fail("a picture without pixels cannot be annotated");
  const double height =
      options.cap_height > 0.0 ? options.cap_height : std::max(7.0, 0.018 * picture.width);
  return {.color = options.ink, .cap_height = height};
}

Image Stacked(const Image& upper, const Image& lower) {
  if (upper.width != lower.width) {
    Fail("pictures that are {} and {} px wide cannot be stacked", upper.width, lower.width);
  }
  Image both(upper.width, upper.height + lower.height);
  Paste(both, upper, 0, 0);
  Paste(both, lower, 0, upper.height);
  return both;
}

Image WithTitle(const Image& picture, std::string_view title, const AnnotationOptions& options) {
  TextStyle style = AnnotationText(picture, options);
  style.weight = 0.17;
  style.cap_height *= 1.15;
  return Stacked(TextBand(picture, title, style, options), picture);
}

Image WithCaption(const Image& picture, std::string_view caption, const AnnotationOptions& options) {
  return Stacked(picture, TextBand(picture, caption, AnnotationText(picture, options), options));
}

Image WithLegend(const Image& picture, const std::vector<LegendEntry>& entries,
                 const AnnotationOptions& options) {
  const TextStyle style = AnnotationText(picture, options);
  if (entries.empty()) return picture;
  const double margin = kMargin * style.cap_height;
  const double pitch = ColumnPitch(entries, style);
  const double room = picture.width - 2.0 * margin + kEntryGap * style.cap_height;
  const auto columns = static_cast<std::size_t>(std::max(1.0, room / pitch));
  const std::size_t rows = (entries.size() + columns - 1) / columns;
  Image band =
      Band(picture, (kLinePitch * static_cast<double>(rows) + kMargin) * style.cap_height, options);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double left = margin + static_cast<double>(i % columns) * pitch;
    const std::size_t row = i / columns;
    const double baseline = (1.5 + kLinePitch * static_cast<double>(row)) * style.cap_height;
    DrawEntry(band, {left, baseline}, entries[i], style);
  }
  return Stacked(picture, band);
}

}  // namespace ariadne::experiments
