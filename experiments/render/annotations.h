#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/render/image.h"
#include "experiments/render/text.h"

namespace ariadne::experiments {

/// Titles and legends in bands above and below a picture, where they hide nothing. Marks over the view
/// (overlay.h) come first, because a title moves the picture down.
struct AnnotationOptions {
  double cap_height = 0.0;  // of the letters [px]; 0: 1.8 % of the picture's width, 6 pt type at 8 cm
  Rgb ink = {30, 30, 30};
  Rgb background = kWhite;
};

/// The picture under a line of text, which shrinks where it is wider than the picture.
Image WithTitle(const Image& picture, std::string_view title, const AnnotationOptions& options = {});

/// The picture over a line of text.
Image WithCaption(const Image& picture, std::string_view caption, const AnnotationOptions& options = {});

struct LegendEntry {
  std::string label;
  Rgb color;
};

/// The picture over a row of colours with their labels; as many rows as the width asks for.
Image WithLegend(const Image& picture, const std::vector<LegendEntry>& entries,
                 const AnnotationOptions& options = {});

/// For pictures with annotations of one's own: their letters, and two pictures of one width in one.
TextStyle AnnotationText(const Image& picture, const AnnotationOptions& options);
Image Stacked(const Image& upper, const Image& lower);

}  // namespace ariadne::experiments
