#include "slam/extract/surface_normals.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/plane3.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kMostCells = 12;    // to each side, where a point is very near
constexpr std::size_t kCellsVisited = 3;  // of these, about
constexpr double kLineLike = 0.02;        // variance on the middle axis by that on the longest: no plane

std::size_t CellsIn(double radius, double range, double step) {
  const double cells = std::ceil(radius / std::max(1e-9, range * step));
  return static_cast<std::size_t>(std::clamp(cells, 1.0, static_cast<double>(kMostCells)));
}

SurfaceNormal NormalAt(const PointCloud& cloud_laser, const DirectionGrid& grid, std::size_t point,
                       const SurfaceNormalOptions& options) {
  const Eigen::Vector3d& p = cloud_laser.positions[point];
  const double radius = std::max(options.radius, options.radius_angle * p.norm());
  const std::size_t rows = CellsIn(radius, p.norm(), grid.row_step());
  const std::size_t columns = CellsIn(radius, p.norm(), grid.column_step());
  const std::size_t stride = std::max<std::size_t>(1, std::min(rows, columns) / kCellsVisited);
  PointMoments moments(p);
  grid.Visit(point, rows, columns, stride, [&](std::size_t neighbor) {
    const Eigen::Vector3d& q = cloud_laser.positions[neighbor];
    if ((q - p).squaredNorm() <= radius * radius) moments.Add(q);
  });
  SurfaceNormal surface;
  if (moments.count() < options.min_neighbors) return surface;
  const PlaneFit fit = FitPlane(moments);
  if (fit.variances[1] <= kLineLike * fit.variances[2]) return surface;
  surface.normal = fit.plane.normal.dot(p) > 0.0 ? Eigen::Vector3d(-fit.plane.normal) : fit.plane.normal;
  surface.mean = moments.Mean();
  surface.rms = std::sqrt(fit.variances[0]);
  surface.flatness = fit.variances[0] / fit.variances.sum();
  return surface;
}

}  // namespace

std::vector<SurfaceNormal> SurfaceNormals(const PointCloud& cloud_laser, const DirectionGrid& grid,
                                          const SurfaceNormalOptions& options) {
  std::vector<SurfaceNormal> normals;
  normals.reserve(cloud_laser.size());
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    normals.push_back(NormalAt(cloud_laser, grid, i, options));
  }
  return normals;
}

}  // namespace ariadne::slam
