#include "experiments/metrics/surface_detection.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ariadne::experiments {
namespace {

using slam::PlanarSurface;

constexpr double kSameNormal = 1e-6;  // 1 - cosine of the normals of one plane
constexpr double kSamePlane = 1e-4;   // of a neighbour from the plane of a hit [m]

/// The hits of a scan's beams in rows of slices.
struct HitGrid {
  std::size_t beams = 0;
  std::vector<Eigen::Vector3d> points_laser;
  std::vector<Eigen::Vector3d> normals_laser;  // zero where nothing was met

  std::size_t slices() const { return points_laser.size() / beams; }
  bool IsHit(std::size_t cell) const { return !normals_laser[cell].isZero(); }
  bool AreCoplanar(std::size_t a, std::size_t b) const {
    if (!IsHit(a) || !IsHit(b)) return false;
    if (1.0 - normals_laser[a].dot(normals_laser[b]) > kSameNormal) return false;
    return std::abs(normals_laser[a].dot(points_laser[b] - points_laser[a])) < kSamePlane;
  }
};

HitGrid CastGrid(const drivers::RayScene& scene, const slam::Pose3& T_map_base,
                 const drivers::AisScannerOptions& options) {
  const drivers::SweepMounting mounting = drivers::AisMounting(options);
  const slam::Pose3 T_laser_map = (T_map_base * mounting.T_base_laser).Inverse();
  const double duration = drivers::AisSliceDuration(options);
  const double step = (options.highest_pitch - options.lowest_pitch) / options.slices;
  HitGrid grid{mounting.beams, {}, {}};
  for (int s = 0; s < options.slices; ++s) {
    const auto rays = drivers::SweepBeams(mounting, drivers::Standing(T_map_base), s * duration,
                                          options.lowest_pitch + s * step, step / duration);
    std::vector<drivers::Hit> hits(rays.size());
    scene.Cast(rays, hits);
    for (std::size_t b = 0; b < rays.size(); ++b) {
      const double distance = hits[b].hit() ? hits[b].distance : 0.0;
      grid.points_laser.push_back(T_laser_map * (rays[b].origin_map + distance * rays[b].direction_map));
      grid.normals_laser.push_back(T_laser_map.rotation * hits[b].normal_map);
    }
  }
  return grid;
}

std::vector<std::size_t> NeighborsOf(const HitGrid& grid, std::size_t cell) {
  std::vector<std::size_t> neighbors;
  if (cell % grid.beams > 0) neighbors.push_back(cell - 1);
  if (cell % grid.beams + 1 < grid.beams) neighbors.push_back(cell + 1);
  if (cell >= grid.beams) neighbors.push_back(cell - grid.beams);
  if (cell + grid.beams < grid.points_laser.size()) neighbors.push_back(cell + grid.beams);
  return neighbors;
}

/// The number of the patch of each hit, from 1; 0 where nothing was met.
std::vector<std::size_t> LabelPatches(const HitGrid& grid) {
  std::vector<std::size_t> labels(grid.points_laser.size(), 0);
  std::size_t patches = 0;
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (labels[seed] != 0 || !grid.IsHit(seed)) continue;
    labels[seed] = ++patches;
    std::vector<std::size_t> front{seed};
    while (!front.empty()) {
      const std::size_t cell = front.back();
      front.pop_back();
      for (const std::size_t neighbor : NeighborsOf(grid, cell)) {
        if (labels[neighbor] != 0 || !grid.AreCoplanar(cell, neighbor)) continue;
        labels[neighbor] = patches;
        front.push_back(neighbor);
      }
    }
  }
  return labels;
}

/// A quarter to each corner of the meshes of the grid that lie in one patch.
std::vector<double> AreasOf(const HitGrid& grid, const std::vector<std::size_t>& labels) {
  std::vector<double> areas(labels.size(), 0.0);
  for (std::size_t s = 0; s + 1 < grid.slices(); ++s) {
    for (std::size_t b = 0; b + 1 < grid.beams; ++b) {
      const std::size_t i = s * grid.beams + b;
      const std::size_t corners[] = {i, i + 1, i + 1 + grid.beams, i + grid.beams};
      if (!std::ranges::all_of(corners, [&](std::size_t c) { return labels[c] == labels[i]; })) continue;
      const auto& p = grid.points_laser;
      const double area = 0.5 * (p[corners[2]] - p[corners[0]]).cross(p[corners[3]] - p[corners[1]]).norm();
      for (const std::size_t corner : corners) areas[corner] += 0.25 * area;
    }
  }
  return areas;
}

/// What a surface has of a patch.
struct Overlap {
  double area = 0.0;      // [m^2]
  double distance = 0.0;  // mean of the points [m]
};

Overlap OverlapOf(const PlanarSurface& surface, const TruePatch& patch,
                  const SurfaceScoreOptions& options) {
  const slam::Plane3 plane = slam::PlaneOf(surface);
  if (plane.normal.dot(patch.plane_laser.normal) < std::cos(options.max_angle)) return {};
  const slam::Box3 box = BoxAround(surface);
  Overlap overlap;
  for (std::size_t i = 0; i < patch.points_laser.size(); ++i) {
    const Eigen::Vector3d& p = patch.points_laser[i];
    const double distance = std::abs(plane.Distance(p));
    if (distance > options.max_distance || box.exteriorDistance(p) > options.max_distance) continue;
    if (!slam::IsWithinOutline(surface, p)) continue;
    overlap.area += patch.areas[i];
    overlap.distance += patch.areas[i] * distance;
  }
  if (overlap.area > 0.0) overlap.distance /= overlap.area;
  return overlap;
}

bool IsToBeFound(const TruePatch& patch, const SurfaceScoreOptions& options) {
  const auto beams = static_cast<double>(patch.points_laser.size()),
             slices = static_cast<double>(patch.slices);
  return patch.area >= options.min_area && patch.slices >= options.min_slices &&
         beams >= options.min_beams * slices;
}

double Angle(const PlanarSurface& surface, const TruePatch& patch) {
  const Eigen::Vector3d normal = slam::PlaneOf(surface).normal;
  return std::atan2(normal.cross(patch.plane_laser.normal).norm(), normal.dot(patch.plane_laser.normal));
}

/// Which surface has most of a patch, or which patch most of a surface.
struct Best {
  Overlap overlap;
  std::size_t index = 0;
};

struct Matches {
  std::vector<Best> of_patch;
  std::vector<Best> of_surface;

  /// Surfaces that lie on the patch more than on others.
  double Pieces(std::size_t patch) const {
    return static_cast<double>(std::ranges::count_if(
        of_surface, [&](const Best& best) { return best.overlap.area > 0.0 && best.index == patch; }));
  }
};

Matches Match(std::span<const PlanarSurface> surfaces_laser, std::span<const TruePatch> patches,
              const SurfaceScoreOptions& options) {
  Matches matches{std::vector<Best>(patches.size()), std::vector<Best>(surfaces_laser.size())};
  for (std::size_t s = 0; s < surfaces_laser.size(); ++s) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const Overlap overlap = OverlapOf(surfaces_laser[s], patches[p], options);
      if (overlap.area > matches.of_patch[p].overlap.area) matches.of_patch[p] = {overlap, s};
      if (overlap.area > matches.of_surface[s].overlap.area) matches.of_surface[s] = {overlap, p};
    }
  }
  return matches;
}

}  // namespace

std::vector<TruePatch> VisiblePatches(const drivers::RayScene& scene, const slam::Pose3& T_map_base,
                                      const drivers::AisScannerOptions& options) {
  const HitGrid grid = CastGrid(scene, T_map_base, options);
  const std::vector<std::size_t> labels = LabelPatches(grid);
  const std::vector<double> areas = AreasOf(grid, labels);
  std::vector<TruePatch> patches(std::ranges::max(labels));
  std::vector<std::set<std::size_t>> slices(patches.size());
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] == 0) continue;
    TruePatch& patch = patches[labels[cell] - 1];
    const Eigen::Vector3d& normal = grid.normals_laser[cell];
    if (patch.points_laser.empty()) patch.plane_laser = {normal, normal.dot(grid.points_laser[cell])};
    patch.points_laser.push_back(grid.points_laser[cell]);
    patch.areas.push_back(areas[cell]);
    patch.area += areas[cell];
    slices[labels[cell] - 1].insert(cell / grid.beams);
  }
  for (std::size_t i = 0; i < patches.size(); ++i) patches[i].slices = slices[i].size();
  return patches;
}

double SurfaceScore::Recall() const {
  return patches == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(patches);
}

double SurfaceScore::Precision() const {
  return surfaces == 0 ? 1.0 : static_cast<double>(true_ones) / static_cast<double>(surfaces);
}

SurfaceScore& SurfaceScore::operator+=(const SurfaceScore& other) {
  patches += other.patches;
  found += other.found;
  surfaces += other.surfaces;
  true_ones += other.true_ones;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(angles, other.angles);
  append(offsets, other.offsets);
  append(covers, other.covers);
  append(pieces, other.pieces);
  return *this;
}

SurfaceScore ScoreSurfaces(std::span<const PlanarSurface> surfaces_laser,
                           std::span<const TruePatch> patches, const SurfaceScoreOptions& options) {
  const Matches matches = Match(surfaces_laser, patches, options);
  SurfaceScore score;
  for (std::size_t s = 0; s < surfaces_laser.size(); ++s) {
    const double area = slam::Area(surfaces_laser[s]);
    if (area < options.min_surface_area) continue;
    ++score.surfaces;
    if (matches.of_surface[s].overlap.area >= 0.5 * area) ++score.true_ones;
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!IsToBeFound(patches[p], options)) continue;
    ++score.patches;
    const Best& best = matches.of_patch[p];
    const double cover = best.overlap.area / patches[p].area;
    if (cover < options.min_cover) continue;
    ++score.found;
    score.covers.push_back(cover);
    score.angles.push_back(Angle(surfaces_laser[best.index], patches[p]));
    score.offsets.push_back(best.overlap.distance);
    score.pieces.push_back(matches.Pieces(p));
  }
  return score;
}

}  // namespace ariadne::experiments
