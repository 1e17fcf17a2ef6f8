#pragma once

#include "experiments/render/camera.h"
#include "experiments/render/image.h"
#include "slam/base/parallel.h"
#include "slam/geometry/triangle_mesh.h"

namespace ariadne::experiments {

struct MeshViewOptions {
  Rgb surface = {196, 200, 206};  // of meshes without colours
  Rgb background = kWhite;
  double ambient = 0.45;  // share of the light that does not come from the camera
  int supersampling = 2;
};

/// A picture of triangles from both sides, in the mean colour of their corners, lit from the camera. A mesh
/// without triangles is an Error.
Image RenderMesh(const slam::TriangleMesh& mesh_map, const Camera& camera, const MeshViewOptions& options,
                 const Parallel& parallel);

}  // namespace ariadne::experiments
