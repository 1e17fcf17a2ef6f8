#pragma once

#include <filesystem>

#include "slam/geometry/triangle_mesh.h"

namespace ariadne::slam {

/// Writes a mesh as binary PLY (little-endian): vertices as 32-bit floats in metres, z up, with their
/// colours where there are some, and faces of three. Error as CheckWritable (writable_drawing.h), or where
/// the file cannot be written.
void WritePlyMesh(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace ariadne::slam
