#pragma once

#include <optional>
#include <span>

#include "slam/extract/planar_surface.h"
#include "slam/extract/slice_noise.h"

namespace ariadne::slam {

/// Sigma across a plane with this unit normal, of a point that the scanner at the origin sees, without the
/// systematic part [m]. SigmaAcross in space.
double SigmaAcross(const Eigen::Vector3d& normal, const Eigen::Vector3d& p, const SliceNoise& noise);

/// Sigma of the systematic part across that plane, as the difference to what ranges shorter by `difference`
/// have [m].
double SystematicAcross(const Eigen::Vector3d& normal, const Eigen::Vector3d& p, double difference,
                        const SliceNoise& noise);

/// The plane of least squared distances, each weighed by the noise, as FitSegment fits a line; without
/// outlines. The covariance takes the independent noise from its prior and the scatter of the points, and
/// adds what ranges have in common. Nothing where the points are on a line.
std::optional<PlanarSurface> FitSurface(std::span<const Eigen::Vector3d> points_laser,
                                        const SliceNoise& noise);

}  // namespace ariadne::slam
