#pragma once

#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/image.h"
#include "experiments/studies/model_output.h"

namespace ariadne::experiments {

/// A camera over a scanner that looks ahead, as wide as a wide-angle lens.
Camera ViewFrom(const slam::Pose3& T_map_laser, const PictureSize& size);

/// Of the poses, those whose views (ViewFrom) show corners of most boxes around objects within 8 m, at
/// least 3 m from each other; the first comes first.
std::vector<std::size_t> BestViews(const BuildingModel& model, const std::vector<slam::Pose3>& T_map_laser,
                                   std::size_t count, const PictureSize& size);

/// The mesh with its greys lifted and drawn together: floors, which beams meet at a grazing angle, return
/// so little that they would be black.
slam::TriangleMesh Lightened(slam::TriangleMesh mesh);

/// The mesh with the edges of all boxes, which it hides where it is in front.
slam::TriangleMesh WithBoxEdges(const slam::TriangleMesh& mesh, const slam::SurfaceModel& surfaces,
                                double radius);

/// The mesh, paler, with the boxes as solids, each in a colour of its own.
slam::TriangleMesh WithSolidBoxes(const slam::TriangleMesh& mesh, const slam::SurfaceModel& surfaces);

}  // namespace ariadne::experiments
