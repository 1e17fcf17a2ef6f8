#pragma once

#include <filesystem>

#include "slam/geometry/box3.h"
#include "slam/geometry/drawing.h"

namespace ariadne::slam {

/// What the writers of meshes can rely on: there are triangles, they name vertices that are there, places
/// are finite and not farther than 1000 km, and there is no colour or one per vertex. Otherwise an Error
/// that begins with the path.
void CheckWritable(const TriangleMesh& mesh, const std::filesystem::path& path);

/// What the writers of drawings can rely on: something is in it, its layers have names (layer_names.h) that
/// differ by more than case, a line has two points or more, and the meshes are as above, or empty.
void CheckWritable(const Drawing& drawing, const std::filesystem::path& path);

/// The smallest box around all points, lines and vertices of a drawing [m].
Box3 BoxAround(const Drawing& drawing);

}  // namespace ariadne::slam
