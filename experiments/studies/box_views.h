#pragma once

#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/image.h"
#include "experiments/studies/model_output.h"

namespace ariadne::experiments {

/// A view of boxes around objects.
struct BoxView {
  std::size_t pose = 0;  // from which of the poses
  Camera camera;
  int boxes = 0;  // that show most of their corners
};

/// From above the scanner, at each of its poses in eight directions: the views that show most boxes within
/// 8 m, and are not of a wall right ahead; their poses are at least 3 m from each other. The first comes
/// first.
std::vector<BoxView> BestViews(const BuildingModel& model, const std::vector<slam::Pose3>& T_map_laser,
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
