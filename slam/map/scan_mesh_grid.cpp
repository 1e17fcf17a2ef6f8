#include "slam/map/scan_mesh_grid.h"

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

using Beam = ScanGrid::Beam;

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

Beam BeamOf(const Eigen::Vector3d& p, std::size_t i, const std::string& name) {
  const double range = p.norm();
  if (!std::isfinite(range) || range <= 0.0) {
    Fail("{}: point {} is {}; remove it", name, i,
         range == 0.0 ? "at the laser itself" : "NaN or infinite");
  }
  Beam beam;
  beam.direction_laser = p / range;
  beam.range = range;
  beam.bearing = std::atan2(std::hypot(p.x(), p.z()), -p.y());
  beam.pitch = std::atan2(p.z(), p.x());
  return beam;
}

std::vector<std::vector<std::size_t>> SlicesOf(const PointCloud& cloud, const std::vector<Beam>& beams) {
  std::vector<std::vector<std::size_t>> slices;
  for (std::size_t s = 0; s < cloud.slice_begin.size(); ++s) {
    const std::size_t end = s + 1 < cloud.slice_begin.size() ? cloud.slice_begin[s + 1] : cloud.size();
    std::vector<std::size_t>& slice = slices.emplace_back();
    for (std::size_t i = cloud.slice_begin[s]; i < end; ++i) slice.push_back(i);
    std::ranges::stable_sort(slice, {}, [&](std::size_t i) { return beams[i].bearing; });
  }
  return slices;
}

/// Joins the neighbours of each slice.
void LinkWithin(ScanGrid& grid, double max_gap) {
  std::vector<double> steps;
  for (const std::vector<std::size_t>& slice : grid.slices) {
    for (std::size_t k = 1; k < slice.size(); ++k) {
      steps.push_back(grid.beams[slice[k]].bearing - grid.beams[slice[k - 1]].bearing);
    }
  }
  grid.bearing_step = Median(std::move(steps));
  for (const std::vector<std::size_t>& slice : grid.slices) {
    for (std::size_t k = 1; k < slice.size(); ++k) {
      Beam& right = grid.beams[slice[k - 1]];
      Beam& left = grid.beams[slice[k]];
      if (left.bearing - right.bearing > max_gap * grid.bearing_step) continue;
      right.left = slice[k];
      left.right = slice[k - 1];
    }
  }
}

/// The beam of a slice that is nearest in bearing, if it is within half a gap. `k` goes along the slice
/// with the bearings that are asked for.
std::size_t Nearest(const ScanGrid& grid, const std::vector<std::size_t>& slice, double bearing,
                    double max_distance, std::size_t& k) {
  const auto distance = [&](std::size_t at) { return std::abs(grid.beams[slice[at]].bearing - bearing); };
  while (k + 1 < slice.size() && distance(k + 1) <= distance(k)) ++k;
  return k < slice.size() && distance(k) <= max_distance ? slice[k] : ScanGrid::kNone;
}

/// Joins neighbours of successive slices, unless slices are missing between them.
void LinkAcross(ScanGrid& grid, double max_gap) {
  const double max_distance = 0.5 * max_gap * grid.bearing_step;
  std::vector<double> steps;
  for (std::size_t s = 0; s + 1 < grid.slices.size(); ++s) {
    std::size_t k_after = 0;
    for (const std::size_t i : grid.slices[s]) {
      Beam& beam = grid.beams[i];
      beam.after = Nearest(grid, grid.slices[s + 1], beam.bearing, max_distance, k_after);
      if (beam.after == ScanGrid::kNone) continue;
      steps.push_back(std::abs(WrapAngle(grid.beams[beam.after].pitch - beam.pitch)));
    }
    std::size_t k_before = 0;
    for (const std::size_t i : grid.slices[s + 1]) {
      Beam& beam = grid.beams[i];
      beam.before = Nearest(grid, grid.slices[s], beam.bearing, max_distance, k_before);
    }
  }
  grid.pitch_step = Median(std::move(steps));
  const auto unlink_far = [&](const Beam& beam, std::size_t& link) {
    if (link == ScanGrid::kNone) return;
    const double step = std::abs(WrapAngle(grid.beams[link].pitch - beam.pitch));
    if (step > max_gap * grid.pitch_step) link = ScanGrid::kNone;
  };
  for (Beam& beam : grid.beams) {
    unlink_far(beam, beam.before);
    unlink_far(beam, beam.after);
  }
}

}  // namespace

ScanGrid GridOf(const PointCloud& cloud_laser, double max_gap, const std::string& name) {
  if (cloud_laser.empty()) return {};
  if (!cloud_laser.reflectance.empty() && cloud_laser.reflectance.size() != cloud_laser.size()) {
    Fail("{}: the cloud has {} points, but {} values of reflectance", name, cloud_laser.size(),
         cloud_laser.reflectance.size());
  }
  if (!cloud_laser.organized()) {
    Fail("{}: the cloud has no slices, which a mesh of neighbouring beams needs; {}", name,
         "read it from a file with the points in the order of the scanner, or mesh an octree of it");
  }
  ScanGrid grid;
  grid.beams.reserve(cloud_laser.size());
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    grid.beams.push_back(BeamOf(cloud_laser.positions[i], i, name));
  }
  grid.slices = SlicesOf(cloud_laser, grid.beams);
  LinkWithin(grid, max_gap);
  LinkAcross(grid, max_gap);
  return grid;
}

}  // namespace ariadne::slam
