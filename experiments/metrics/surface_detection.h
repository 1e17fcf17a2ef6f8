#pragma once

#include <span>
#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "slam/extract/planar_surface.h"

namespace ariadne::experiments {

/// A flat part of the true surfaces as the beams of a scan sample it, without their errors: beams that are
/// neighbours and meet one plane.
struct TruePatch {
  slam::Plane3 plane_laser;  // normal towards the scanner
  std::vector<Eigen::Vector3d> points_laser;
  std::vector<double> areas;  // for which each point stands; they sum up to that of the patch [m^2]
  double area = 0.0;          // between the points [m^2]
  std::size_t slices = 0;     // in which it is met
};

/// All patches that a scan from here can see.
std::vector<TruePatch> VisiblePatches(const drivers::RayScene& scene, const slam::Pose3& T_map_base,
                                      const drivers::AisScannerOptions& options);

struct SurfaceScoreOptions {
  double min_area = 0.5;          // of a patch that is to be found [m^2]
  std::size_t min_slices = 5;     // in which it is met: the top of a table at eye level is hardly visible
  double min_beams = 5.0;         // of a patch, per slice in the mean: fewer make no line
  double min_cover = 0.5;         // share of the patch in the outline of the surface that stands for it
  double max_angle = 0.0873;      // between their normals, 5 deg [rad]
  double max_distance = 0.05;     // of a point of the patch from the surface [m]
  double min_surface_area = 0.1;  // of a surface that counts for the precision [m^2]
};

/// How well surfaces stand for patches; sums over scans by +=.
struct SurfaceScore {
  std::size_t patches = 0;      // to be found
  std::size_t found = 0;        // of these
  std::size_t surfaces = 0;     // that count
  std::size_t true_ones = 0;    // of these: half of their area or more is on one patch of any size
  std::vector<double> angles;   // of each patch found, between the normals [rad]
  std::vector<double> offsets;  // of each patch found, mean distance of its points from the surface [m]
  std::vector<double> covers;   // of each patch found, the share that its surface covers
  std::vector<double> pieces;   // of each patch found, surfaces that lie on it more than elsewhere

  double Recall() const;
  double Precision() const;
  SurfaceScore& operator+=(const SurfaceScore& other);
};

SurfaceScore ScoreSurfaces(std::span<const slam::PlanarSurface> surfaces_laser,
                           std::span<const TruePatch> patches, const SurfaceScoreOptions& options);

}  // namespace ariadne::experiments
