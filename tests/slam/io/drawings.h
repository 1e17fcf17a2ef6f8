#pragma once

#include <string>

#include "slam/geometry/drawing.h"

/// What the tests of exports write.
namespace ariadne::slam::testing_support {

/// A box from (1, -1, 0.25) to (3, 2, 1.75), each corner of another colour.
inline TriangleMesh ColoredBox() {
  TriangleMesh box;
  for (int i = 0; i < 8; ++i) {
    box.vertices.emplace_back(i & 1 ? 3.0 : 1.0, i & 2 ? 2.0 : -1.0, i & 4 ? 1.75 : 0.25);
    box.colors.push_back({static_cast<std::uint8_t>(30 * i), 100, static_cast<std::uint8_t>(255 - 30 * i)});
  }
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

/// Three points, a line, a closed outline, an open one, and the box, in three layers.
inline Drawing SmallDrawing() {
  Drawing drawing;
  drawing.layers.push_back({"scan-000", {255, 0, 0}, {{0, 0, 0}, {1, 2, 0.5}, {-3.5, 4, 1}}, {}, {}});
  drawing.layers.push_back({"walls", {0, 0, 0}, {}, {}, {}});
  drawing.layers.back().lines = {{{{0, 0, 0}, {5, 0, 0}}, false},
                                 {{{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0}}, true},
                                 {{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}, false}};
  drawing.layers.push_back({"objects", {0, 255, 0}, {}, {}, ColoredBox()});
  return drawing;
}

}  // namespace ariadne::slam::testing_support
