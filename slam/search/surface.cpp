#include "slam/search/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "slam/base/error.h"
#include "slam/geometry/plane3.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kMaxNeighbors = 64;
constexpr std::size_t kChunk = 256;

// Neighbours are on a line, not on a plane, where the spread across it is below 3 % of that along it.
constexpr double kLineRatio = 1e-3;
// And they are not on a plane where its thickness is above 45 % of its smaller spread. Ten points that fill
// space evenly rarely stay below that.
constexpr double kThicknessRatio = 0.2;
// The mean of neighbours all around is near the point (0.2 of the radius for ten random ones), that of a
// half disc is 4 / (3 pi) = 0.42 of the radius away.
constexpr double kBoundaryOffset = 0.35;

}  // namespace

SurfacePoint EstimateSurface(const KdTree& tree, std::size_t point, int neighbors) {
  const std::vector<Eigen::Vector3d>& points = tree.points();
  std::array<Neighbor, kMaxNeighbors> nearest;
  const std::size_t found =
      tree.NearestK(points[point], std::span(nearest).first(static_cast<std::size_t>(neighbors)));
  SurfacePoint surface;
  if (found < 3) return surface;
  PointMoments moments(points[point]);
  for (std::size_t i = 0; i < found; ++i) moments.Add(points[nearest[i].index]);
  surface.radius = std::sqrt(nearest[found - 1].squared_distance);

  const PlaneFit fit = FitPlane(moments);
  const bool line = fit.variances[1] <= kLineRatio * fit.variances[2];
  const bool thick = fit.variances[0] > kThicknessRatio * fit.variances[1];
  if (line || thick) return surface;
  const bool away = fit.plane.normal.dot(points[point]) > 0.0;
  surface.normal = away ? Eigen::Vector3d(-fit.plane.normal) : fit.plane.normal;
  const Eigen::Vector3d offset = moments.Mean() - points[point];
  const Eigen::Vector3d in_plane = offset - surface.normal.dot(offset) * surface.normal;
  surface.boundary = in_plane.norm() > kBoundaryOffset * surface.radius;
  return surface;
}

std::vector<SurfacePoint> EstimateSurfaces(const KdTree& tree, int neighbors, const Parallel& parallel) {
  if (neighbors < 3 || neighbors > static_cast<int>(kMaxNeighbors)) {
    Fail("a surface takes 3 to {} neighbours, not {}", kMaxNeighbors, neighbors);
  }
  std::vector<SurfacePoint> surfaces(tree.points().size());
  parallel.For(surfaces.size(), kChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) surfaces[i] = EstimateSurface(tree, i, neighbors);
  });
  return surfaces;
}

}  // namespace ariadne::slam
