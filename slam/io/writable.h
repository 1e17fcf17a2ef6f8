#pragma once

#include <cstddef>
#include <optional>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// What a writer can rely on, because a reader will: as many attributes as points (or none), coordinates
/// and normals finite, reflectance not infinite. Error with the point where it is not so.
void CheckWritable(const PointCloud& cloud);

/// The same for formats whose files cannot be empty.
void CheckWritableWithPoints(const PointCloud& cloud);

/// Error for a pose that is NaN or infinite, or whose quaternion is not a rotation.
void CheckWritable(const Pose3& pose);

/// The number of points per slice where all slices have the same, as in a grid; else nothing.
std::optional<std::size_t> GridColumns(const PointCloud& cloud);

/// A coordinate [m] as the formats with 32-bit floats store it; these keep 4 um at 60 m. Error where it is
/// too large for a float.
float FloatCoordinate(double coordinate);

}  // namespace ariadne::slam
