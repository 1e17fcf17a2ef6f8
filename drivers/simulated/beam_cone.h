#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/simulated/range_finder_options.h"
#include "drivers/simulated/ray_scene.h"

namespace ariadne::drivers {

/// The share of a beam's light that comes back from one of its rays.
struct RayReturn {
  double distance = 0.0;  // [m]
  double weight = 0.0;    // of the ray in its beam
  double surface = 0.0;   // reflectance times cosine of incidence: what a diffuse surface sends back

  double light() const { return weight * surface / (distance * distance); }  // as it arrives
};

/// What a beam measures: surfaces within a pulse length are one echo at their mean, weighed by light.
struct Echo {
  double distance = 0.0;  // [m]
  double light = 0.0;     // as it arrives; 1 for white paper at 1 m head-on [1/m^2]
};

/// The rays that stand for a beam: the centre with weight 1/4 and a rim at sqrt(2/3) of the cone's radius,
/// so that the mean of a quadratic over the disc is exact. Without mixed pixels, the centre alone.
class BeamCone {
 public:
  explicit BeamCone(const RangeFinderOptions& options);

  /// Of each ray, the centre first; they sum to 1.
  const std::vector<double>& weights() const { return weights_; }

  /// Appends the rays of a beam, the centre first. `turn` turns the rim about the beam [rad].
  void AppendRays(const Ray& beam, double turn, std::vector<Ray>& rays) const;

 private:
  std::vector<double> weights_;
  std::vector<Eigen::Vector2d> rim_;  // offsets from a unit direction, across it
};

/// The echo that the device reports; nothing where all are too weak. Sorts `returns`.
std::optional<Echo> ChooseEcho(std::span<RayReturn> returns, const RangeFinderOptions& options);

}  // namespace ariadne::drivers
