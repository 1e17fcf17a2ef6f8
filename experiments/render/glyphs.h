#pragma once

#include <vector>

#include "experiments/render/draw.h"

namespace ariadne::experiments {

/// A letter of the built-in font as strokes. x runs to the right from the letter's left edge and y up from
/// the baseline; a capital is 6 units high, a small letter 4, and a tail ends at -2.
struct Glyph {
  double width = 0.0;  // without the gap to the next letter
  std::vector<Polyline> strokes;
};

inline constexpr double kCapUnits = 6.0;
inline constexpr double kLetterGapUnits = 1.75;

/// The glyph of an ASCII character (32 to 126) or of one of the Greek letters that formulas need; a small
/// box for any other.
Glyph GlyphOf(char32_t character);

}  // namespace ariadne::experiments
