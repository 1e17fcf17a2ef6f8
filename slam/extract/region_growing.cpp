#include "slam/extract/region_growing.h"

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"
#include "slam/extract/region_outline.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kReach = 2;           // cells: one beam or slice may be missing
constexpr double kRough = 4.0;              // sigma: a neighbourhood that is rougher has an edge in it
constexpr std::uint32_t kFree = 0;          // a point that is in no region
constexpr std::size_t kPointsForAFit = 30;  // before, the plane of the seed's neighbourhood is better
constexpr double kRefit = 1.3;              // times as many points as at the last fit

/// What regions grow on.
struct Field {
  Field(const PointCloud& cloud, const DirectionGrid& directions, const std::vector<SurfaceNormal>& around,
        const RegionGrowingOptions& chosen)
      : cloud_laser(cloud), grid(directions), normals(around), options(chosen) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const SurfaceNormal& surface = normals[i];
      smooth.push_back(surface.exists() &&
                       surface.rms <= kRough * SigmaAcross(surface.normal, p(i), options.noise));
    }
  }

  const PointCloud& cloud_laser;
  const DirectionGrid& grid;
  const std::vector<SurfaceNormal>& normals;
  const RegionGrowingOptions& options;
  std::vector<bool> smooth;  // whether a point's normal is that of one surface, and not of an edge

  const Eigen::Vector3d& p(std::size_t point) const { return cloud_laser.positions[point]; }

  /// Whether a region may go on from a point: not at edges, but where the beams are so far apart that a
  /// point has no normal, and the distance from the plane is all that there is.
  bool LeadsOn(std::size_t point) const { return !normals[point].exists() || smooth[point]; }

  bool AreNear(std::size_t a, std::size_t b) const {
    const double step = static_cast<double>(kReach) * std::max(grid.row_step(), grid.column_step());
    const double range = std::min(p(a).norm(), p(b).norm());
    return (p(a) - p(b)).norm() <=
           std::max(options.min_gap, range * step / std::sin(options.grazing_angle));
  }
};

/// A region while it grows.
class Region {
 public:
  Region(const Field& field, std::size_t seed)
      : field_(&field),
        moments_(field.p(seed)),
        mean_(field.normals[seed].mean),
        normal_(field.normals[seed].normal) {
    Add(seed);
  }

  bool Takes(std::size_t point) const {
    const Eigen::Vector3d& p = field_->p(point);
    const double distance = std::abs(normal_.dot(p - mean_));
    const SliceNoise& noise = field_->options.noise;
    const double sigma = std::hypot(SigmaAcross(normal_, p, noise),
                                    SystematicAcross(normal_, p, p.norm() - mean_.norm(), noise));
    if (distance > field_->options.max_deviation * sigma) return false;
    return !field_->smooth[point] ||
           normal_.dot(field_->normals[point].normal) >= std::cos(field_->options.max_angle);
  }

  void Add(std::size_t point) {
    points_.push_back(point);
    moments_.Add(field_->p(point));
    if (points_.size() < kPointsForAFit) return;
    if (static_cast<double>(points_.size()) < kRefit * static_cast<double>(fitted_)) return;
    const Eigen::Vector3d normal = FitPlane(moments_).plane.normal;
    normal_ = normal.dot(normal_) < 0.0 ? Eigen::Vector3d(-normal) : normal;
    mean_ = moments_.Mean();
    fitted_ = points_.size();
  }

  const std::vector<std::size_t>& points() const { return points_; }

 private:
  const Field* field_;
  std::vector<std::size_t> points_;
  PointMoments moments_;
  Eigen::Vector3d mean_;
  Eigen::Vector3d normal_;
  std::size_t fitted_ = 0;
};

/// All points that a region reaches from its seed; they are given the region's number.
std::vector<std::size_t> Grow(const Field& field, std::size_t seed, std::uint32_t number,
                              std::vector<std::uint32_t>& region_of) {
  Region region(field, seed);
  region_of[seed] = number;
  for (std::size_t next = 0; next < region.points().size(); ++next) {
    const std::size_t point = region.points()[next];
    if (!field.LeadsOn(point)) continue;
    field.grid.Visit(point, kReach, kReach, 1, [&](std::size_t neighbor) {
      if (region_of[neighbor] != kFree || !field.AreNear(point, neighbor) || !region.Takes(neighbor))
        return;
      region_of[neighbor] = number;
      region.Add(neighbor);
    });
  }
  std::vector<std::size_t> points = region.points();
  std::ranges::sort(points);
  return points;
}

std::optional<PlanarSurface> SurfaceOf(const Field& field, const std::vector<std::size_t>& points) {
  if (points.size() < static_cast<std::size_t>(field.options.min_points)) return std::nullopt;
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(points.size());
  for (const std::size_t i : points) positions.push_back(field.p(i));
  std::optional<PlanarSurface> surface = FitSurface(positions, field.options.noise);
  if (!surface) return std::nullopt;
  surface->outlines =
      field.cloud_laser.organized()
          ? OutlineOfRuns(*surface, field.cloud_laser, points, field.grid, kReach)
          : OutlineOfSquares(*surface, field.cloud_laser, points, field.options.outline_cell);
  if (Area(*surface) < field.options.min_area) return std::nullopt;
  return surface;
}

/// Flattest first.
std::vector<std::size_t> Seeds(const Field& field) {
  std::vector<std::size_t> seeds;
  for (std::size_t i = 0; i < field.cloud_laser.size(); ++i) {
    if (field.smooth[i]) seeds.push_back(i);
  }
  std::ranges::stable_sort(seeds, {}, [&](std::size_t i) { return field.normals[i].flatness; });
  return seeds;
}

}  // namespace

std::vector<PlanarSurface> GrowRegions(const PointCloud& cloud_laser, const RegionGrowingOptions& options) {
  CheckOptions(options, "regions.");
  if (const auto bad = FirstNonFinite(cloud_laser)) {
    Fail("point {} of the cloud is no place; leave out beams without a return", *bad);
  }
  const DirectionGrid grid = cloud_laser.organized()
                                 ? DirectionGrid::OfSlices(cloud_laser)
                                 : DirectionGrid::OfDirections(cloud_laser, options.direction_step);
  const std::vector<SurfaceNormal> normals = SurfaceNormals(cloud_laser, grid, options.normals);
  const Field field(cloud_laser, grid, normals, options);
  std::vector<std::uint32_t> region_of(cloud_laser.size(), kFree);
  std::vector<PlanarSurface> surfaces;
  std::uint32_t regions = kFree;
  for (const std::size_t seed : Seeds(field)) {
    if (region_of[seed] != kFree) continue;
    const std::vector<std::size_t> points = Grow(field, seed, ++regions, region_of);
    if (auto surface = SurfaceOf(field, points)) {
      surfaces.push_back(*std::move(surface));
    } else {
      for (const std::size_t i : points) region_of[i] = kFree;  // others may have them
    }
  }
  return surfaces;
}

}  // namespace ariadne::slam
