#pragma once

#include <span>

#include "slam/extract/direction_grid.h"
#include "slam/extract/planar_surface.h"

namespace ariadne::slam {

/// The outline of points of an organized cloud (ascending indices) in a surface's plane: runs of points in
/// the slices, joined to the runs beside them in the next slice. Points up to `max_missed` cells apart are
/// one run.
std::vector<Polygon2> OutlineOfRuns(const PlanarSurface& surface, const PointCloud& cloud_laser,
                                    std::span<const std::size_t> points, const DirectionGrid& grid,
                                    std::size_t max_missed);

/// The outline of points in any order: the squares of the plane, of edge `cell` [m], that hold some.
std::vector<Polygon2> OutlineOfSquares(const PlanarSurface& surface, const PointCloud& cloud,
                                       std::span<const std::size_t> points, double cell);

}  // namespace ariadne::slam
