#pragma once

#include <filesystem>

#include "slam/geometry/triangle_mesh.h"

namespace ariadne::slam {

/// Writes a mesh as binary glTF 2.0 (.glb): one primitive of triangles, seen from either side, with the
/// colours of its vertices made linear as glTF wants them. The vertices remain in metres with z up; the
/// node that holds the mesh turns them to glTF's y up. Error as CheckWritable (writable_drawing.h), for
/// more than 4 GB, or where the file cannot be written.
///
/// Written here and not by assimp's exporter, which unshares the vertices of a mesh and joins them again:
/// what is within 10 um becomes one vertex, and a mesh of millions of triangles takes gigabytes.
void WriteGlb(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace ariadne::slam
