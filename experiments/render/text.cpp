#include "experiments/render/text.h"

#include "experiments/render/glyphs.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// The glyphs of a text in UTF-8; bytes that are none show as boxes.
std::vector<Glyph> GlyphsOf(std::string_view text) {
  std::vector<char32_t> characters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U && !characters.empty()) {
      characters.back() = (characters.back() << 6U) | (byte & 0x3FU);
    } else {
      characters.push_back(byte >= 0xE0U ? byte & 0x0FU : byte >= 0xC0U ? byte & 0x1FU : byte);
    }
  }
  std::vector<Glyph> glyphs;
  for (const char32_t character : characters) glyphs.push_back(GlyphOf(character));
  return glyphs;
}

}  // namespace

double TextWidth(std::string_view text, const TextStyle& style) {
  double units = text.empty() ? 0.0 : -kLetterGapUnits;
  for (const Glyph& glyph : GlyphsOf(text)) units += glyph.width + kLetterGapUnits;
  return (units / kCapUnits + (text.empty() ? 0.0 : style.weight)) * style.cap_height;
}

void DrawText(Image& canvas, const Eigen::Vector2d& anchor, std::string_view text, const TextStyle& style,
              Align align) {
  if (!(style.cap_height > 0.0)) Fail("the height of letters must be positive, not {}", style.cap_height);
  const double px_per_unit = style.cap_height / kCapUnits;
  const double share_left = align == Align::kLeft ? 0.0 : align == Align::kCenter ? 0.5 : 1.0;
  // Strokes reach half their width beyond the glyph's outline.
  double left = anchor.x() - share_left * TextWidth(text, style) + 0.5 * style.weight * style.cap_height;

  std::vector<Polyline> lines;
  for (const Glyph& glyph : GlyphsOf(text)) {
    for (Polyline line : glyph.strokes) {
      for (Eigen::Vector2d& p : line) p = {left + p.x() * px_per_unit, anchor.y() - p.y() * px_per_unit};
      lines.push_back(std::move(line));
    }
    left += (glyph.width + kLetterGapUnits) * px_per_unit;
  }
  DrawPolylines(
      canvas, lines,
      {.color = style.color, .width = style.weight * style.cap_height, .halo_width = style.halo_width});
}

}  // namespace ariadne::experiments
