#pragma once

#include <filesystem>

#include "slam/geometry/drawing.h"

namespace ariadne::slam {

/// Writes a drawing as VRML97: points as PointSet, lines as IndexedLineSet, triangles as IndexedFaceSet
/// with a colour per vertex where there is one, each layer as a Group named "layer_" and its name. VRML has
/// y up: a Transform around everything turns z up into it. Metres, to 0.1 mm. Two viewpoints: from the
/// front and above, which programs open with, and from right above; a white sky. Error as CheckWritable
/// (writable_drawing.h), or where the file cannot be written.
void WriteVrml(const std::filesystem::path& path, const Drawing& drawing);

/// The same for a mesh alone.
void WriteVrml(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace ariadne::slam
