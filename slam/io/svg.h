#pragma once

#include <filesystem>

#include "slam/base/options.h"
#include "slam/geometry/drawing.h"

namespace ariadne::slam {

struct SvgOptions {
  double scale = 100.0;
  double line_width = 0.25;
  double point_size = 0.25;
  double margin = 10.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scale", self.scale, Unit(""), Range{0.001, 1e6},
          "metres of the building in a metre of paper; 1:100 is usual for the plan of a floor");
    visit("line_width", self.line_width, Unit("mm"), Range{0.001, 100.0}, "on paper; a pen of ISO 128");
    visit("point_size", self.point_size, Unit("mm"), Range{0.001, 100.0},
          "diameter on paper; points of a wall a few centimetres apart touch at 1:100");
    visit("margin", self.margin, Unit("mm"), Range{0.0, 1000.0}, "around the drawing, on paper");
  }
};

/// Writes a drawing as seen from above, x to the right and y up: to scale if printed at 100 %, with a scale
/// bar. Each layer is one of Inkscape's; its coordinates are map coordinates in metres, to 0.1 mm, which
/// the layer's transform puts on paper. Error as CheckWritable (writable_drawing.h), where an option is out
/// of its range, or where the file cannot be written.
void WriteSvg(const std::filesystem::path& path, const Drawing& drawing, const SvgOptions& options = {});

}  // namespace ariadne::slam
