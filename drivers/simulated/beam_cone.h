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
  double weight = 0.0;    // of the ray in its beam; they sum to 1
  double surface = 0.0;   // reflectance times cosine of incidence: what a diffuse surface sends back

  double light() const { return weight * surface / (distance * distance); }  // as it arrives
};

/// What a beam measures: surfaces within a pulse length are one echo at their mean, weighed by light.
struct Echo {
  double distance = 0.0;  // [m]
  double light = 0.0;     // as it arrives; 1 for white paper at 1 m head-on [1/m^2]
};

/// How many rays stand for a beam.
std::size_t RaysPerBeam(const RangeFinderOptions& options);

/// The weight of each ray of a beam, the centre first. Centre 1/4, rim 3/4 at sqrt(2/3) of the cone's
/// radius: the mean of a quadratic over the disc is exact.
std::vector<double> RayWeights(const RangeFinderOptions& options);

/// Appends the rays of a beam, the centre first. `turn` turns the rim about the beam [rad].
void AppendBeamRays(const Ray& beam, double turn, const RangeFinderOptions& options,
                    std::vector<Ray>& rays);

/// The echo that the device reports; nothing where all are too weak. Sorts `returns`.
std::optional<Echo> ChooseEcho(std::span<RayReturn> returns, const RangeFinderOptions& options);

}  // namespace ariadne::drivers
