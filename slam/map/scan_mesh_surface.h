#pragma once

#include <array>
#include <vector>

#include "slam/map/scan_mesh.h"
#include "slam/map/scan_mesh_grid.h"

namespace ariadne::slam {

/// Whether the surface goes on from a beam to its neighbours.
struct Continuity {
  bool left = false;
  bool before = false;
  bool after = false;
};

/// It goes on where the range changes by no more than `options.jump`, or than it does on a surface at 45
/// deg; or where each of the two beams is where a plane through the other and its outer neighbour lets
/// expect it. In a plane 1 / range is linear, so that the floor far away has no jumps.
std::vector<Continuity> FindContinuity(const ScanGrid& grid, const ScanMeshOptions& options);

/// What the neighbours of a beam tell of the surface that it hits.
struct BeamSurface {
  double range = 0.0;  // to the surface along the beam [m]
  Eigen::Vector3d normal_laser =
      Eigen::Vector3d::Zero();  // towards the scanner; zero where too few tell it
};

/// Fits a plane to each beam and its neighbours, over continuous links only and with weights that forget
/// what is off the plane, so that edges remain.
std::vector<BeamSurface> FitSurfaces(const ScanGrid& grid, const std::vector<Continuity>& continuity,
                                     const ScanMeshOptions& options);

}  // namespace ariadne::slam
