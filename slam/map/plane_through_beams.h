#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam/map/scan_mesh_surface.h"

namespace ariadne::slam {

/// The surface at a beam, from its neighbours. A plane is met by a beam at 1 / range = m . direction: a
/// linear fit in the coordinates of a tangent plane to the unit sphere at the beam.
class PlaneThroughBeams {
 public:
  /// `range_sigma` of the scanner [m].
  explicit PlaneThroughBeams(double range_sigma) : tolerance_(2.5 * range_sigma) {}

  /// The beam as it was, without a normal, where the window is too small or the beam on none of its planes.
  BeamSurface Fit(const ScanGrid& grid, std::size_t center, const std::vector<std::size_t>& window);

 private:
  struct Sample {
    Eigen::Vector3d x;  // 1 and the place in the tangent plane
    double value;       // 1 / range along the middle beam [1/m]
    double scale;       // from an error of the value to one of the range [m^2]
  };
  struct NormalEquations;

  static std::size_t EighthOf(const Sample& sample);
  double Weight(const Eigen::Vector3d& plane, const Sample& sample) const;
  double Agreement(const Eigen::Vector3d& plane) const;
  Eigen::Vector3d BestOfHalves(const Eigen::Vector3d& plane_of_all) const;
  std::optional<Eigen::Vector3d> FitRobustly() const;

  double tolerance_;  // at which a neighbour counts a quarter [m]
  std::vector<Sample> samples_;
};

}  // namespace ariadne::slam
