#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "slam/io/stream_reader.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// How lines of "x y z [reflectance]" may look.
struct TextPointSyntax {
  std::string_view delimiters;  // between numbers, beside blanks
  bool comments = false;        // from '#' to the end of a line, and lines that begin with "//"
};

/// Reads the rest of a text of points, in the axes and the unit of the file. All lines have three numbers,
/// or all have four; blank lines are skipped. `line_ends` (CountLineEnds) tells how much memory to take at
/// once. Error with file and line for anything else, and for a text without points.
PointCloud ReadTextPoints(StreamReader& reader, const TextPointSyntax& syntax,
                          std::optional<std::size_t> line_ends);

}  // namespace ariadne::slam
