#include "experiments/render/glyphs.h"

#include <cstddef>
#include <string_view>

#include "experiments/render/font_table.h"

namespace ariadne::experiments {
namespace {

constexpr double kBaseline = 2.0;  // of the table's grid
constexpr int kPiecesPerCurve = 8;

struct StrokePoint {
  Eigen::Vector2d position;
  bool is_control = false;
};

/// The points of one stroke of the table, with the end points between control points put in.
std::vector<StrokePoint> ParsedStroke(std::string_view source) {
  std::vector<StrokePoint> points;
  for (std::size_t i = 0; i + 1 < source.size(); i += 2) {
    const bool is_control = source[i] == '~';
    if (is_control) ++i;
    const Eigen::Vector2d p(source[i] - '0', source[i + 1] - '0' - kBaseline);
    if (is_control && !points.empty() && points.back().is_control) {
      points.push_back({0.5 * (points.back().position + p), false});
    }
    points.push_back({p, is_control});
  }
  return points;
}

/// A dot as wide as a stroke looks too small beside it, so it becomes a little diamond.
Polyline Dot(const Eigen::Vector2d& center) {
  constexpr double kRadius = 0.18;
  const Eigen::Vector2d x = kRadius * Eigen::Vector2d::UnitX();
  const Eigen::Vector2d y = kRadius * Eigen::Vector2d::UnitY();
  return {center + x, center + y, center - x, center - y, center + x};
}

Polyline Flattened(const std::vector<StrokePoint>& points) {
  if (points.size() == 2 && points[0].position == points[1].position) return Dot(points[0].position);
  Polyline line;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i].position;
    if (!points[i].is_control) {
      line.push_back(p);
      continue;
    }
    const Eigen::Vector2d from = points[i - 1].position;
    const Eigen::Vector2d to = points[i + 1].position;
    for (int piece = 1; piece < kPiecesPerCurve; ++piece) {
      const double s = static_cast<double>(piece) / kPiecesPerCurve;
      line.push_back((1.0 - s) * (1.0 - s) * from + 2.0 * s * (1.0 - s) * p + s * s * to);
    }
  }
  return line;
}

const GlyphSource& SourceOf(char32_t character) {
  if (character >= U' ' && character <= U'~') return kFontTable[character - U' '];
  for (const FurtherGlyphSource& further : kFurtherGlyphs) {
    if (further.character == character) return further.source;
  }
  return kUnknownGlyph;
}

}  // namespace

Glyph GlyphOf(char32_t character) {
  const GlyphSource& source = SourceOf(character);
  Glyph glyph{static_cast<double>(source.width), {}};
  for (std::string_view rest = source.strokes; !rest.empty();) {
    const std::size_t blank = rest.find(' ');
    glyph.strokes.push_back(Flattened(ParsedStroke(rest.substr(0, blank))));
    rest = blank == std::string_view::npos ? "" : rest.substr(blank + 1);
  }
  return glyph;
}

}  // namespace ariadne::experiments
