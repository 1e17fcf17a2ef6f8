#pragma once

#include <string_view>

#include "experiments/render/draw.h"

namespace ariadne::experiments {

/// Text in the built-in font: ASCII and a few Greek letters as UTF-8, one line. A character that the font
/// does not have shows as a box.
struct TextStyle {
  Rgb color = kBlack;
  double cap_height = 24.0;  // of a capital letter [px]
  double weight = 0.13;      // width of the strokes as a share of cap_height; 0.18 is bold
  double halo_width = 0.0;   // of the white rim that sets the text off from what is below [px]
};

enum class Align { kLeft, kCenter, kRight };

/// From the left edge of the first letter to the right edge of the last. [px]
double TextWidth(std::string_view text, const TextStyle& style);

/// Writes so that `anchor` is the left end, the centre or the right end of the baseline. [px]
void DrawText(Image& canvas, const Eigen::Vector2d& anchor, std::string_view text,
              const TextStyle& style = {}, Align align = Align::kLeft);

}  // namespace ariadne::experiments
