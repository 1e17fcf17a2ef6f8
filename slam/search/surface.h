#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam/base/parallel.h"
#include "slam/search/kd_tree.h"

namespace ariadne::slam {

/// What the nearest neighbours of a point tell about the surface on which it lies.
struct SurfacePoint {
  /// Of the plane through the neighbours, by total least squares; towards the origin, where the scanner is
  /// in a scan's own frame. Zero where they determine none: they lie on a line (one slice of a coarse
  /// scan), or fill space (stray points, noise as large as their distance).
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /// The neighbours are all to one side: the scan ends here, though the surface may go on.
  bool boundary = false;
  /// Distance of the farthest of the neighbours [m].
  double radius = 0.0;

  bool has_normal() const { return !normal.isZero(0.0); }
};

/// The surface at one point of the tree, given by its index, from its nearest neighbours (3 to 64, itself
/// included).
SurfacePoint EstimateSurface(const KdTree& tree, std::size_t point, int neighbors);

/// The same at each point of the tree.
std::vector<SurfacePoint> EstimateSurfaces(const KdTree& tree, int neighbors, const Parallel& parallel);

}  // namespace ariadne::slam
