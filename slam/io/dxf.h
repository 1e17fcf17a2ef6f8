#pragma once

#include <filesystem>

#include "slam/geometry/drawing.h"

namespace ariadne::slam {

/// Writes a drawing as ASCII DXF of release 12 (AC1009), the one release that every program since 1992
/// reads and that needs no handles, blocks or dictionaries around the drawing. A layer becomes a layer with
/// the nearest of AutoCAD's 255 colours; points become POINT, lines LINE or POLYLINE, triangles 3DFACE with
/// the mean colour of their vertices. Metres to 0.1 mm, z up; $INSUNITS says so, a variable of later
/// releases that others skip. Error as CheckWritable (writable_drawing.h), or where the file cannot be
/// written.
void WriteDxf(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace ariadne::slam
