#include "drivers/calibration/calibration_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ariadne::drivers {
namespace {

/// A beam with what its slice is.
struct SliceBeam {
  MeasuredBeam beam;
  std::size_t slice = 0;
};

/// In the order of ToPointCloud.
std::vector<SliceBeam> BeamsOf(const slam::Scan& scan, std::size_t first_slice) {
  std::vector<SliceBeam> beams;
  for (std::size_t i = 0; i < scan.sweeps.size(); ++i) {
    const slam::LaserSweep& sweep = scan.sweeps[i];
    for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
      if (!std::isfinite(sweep.ranges[beam])) continue;
      const double angle = scan.scanner.first_angle + static_cast<double>(beam) * scan.scanner.angle_step;
      const double pitch = sweep.pitch + sweep.pitch_rate * slam::BeamTime(scan.scanner, beam);
      beams.push_back({{angle, pitch, static_cast<double>(sweep.ranges[beam])}, first_slice + i});
    }
  }
  return beams;
}

slam::Pose3 PoseOf(const ScannerMounting& mounting) {
  slam::Pose3 T_base_laser;
  T_base_laser.translation = {0.0, 0.0, mounting.height};
  T_base_laser.rotation = Eigen::AngleAxisd(-mounting.pitch, Eigen::Vector3d::UnitY()) *
                          Eigen::AngleAxisd(mounting.roll, Eigen::Vector3d::UnitX());
  return T_base_laser;
}

std::optional<PlaneKind> KindOf(slam::SurfaceClass surface, bool ceilings) {
  if (surface == slam::SurfaceClass::kFloor) return PlaneKind::kFloor;
  if (surface == slam::SurfaceClass::kWall) return PlaneKind::kWall;
  if (surface == slam::SurfaceClass::kCeiling && ceilings) return PlaneKind::kCeiling;
  return std::nullopt;
}

CalibrationPlane PlaneFor(const slam::PlanarSurface& surface_base, PlaneKind kind) {
  const slam::Plane3 plane = slam::PlaneOf(surface_base);
  CalibrationPlane result;
  result.kind = kind;
  if (kind == PlaneKind::kCeiling) result.offset = surface_base.T_frame_plane.translation.z();
  if (kind == PlaneKind::kWall) {
    result.bearing = std::atan2(plane.normal.y(), plane.normal.x());
    result.offset = plane.offset;
  }
  return result;
}

/// The points of the surface, and of the plane around it no others.
void TakeBeams(const slam::PlanarSurface& surface_laser, const std::vector<SliceBeam>& beams,
               const slam::PointCloud& cloud_laser, const CalibrationPlanesOptions& options,
               CalibrationPlane& plane) {
  const slam::Plane3 found = slam::PlaneOf(surface_laser);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Eigen::Vector3d& p_laser = cloud_laser.positions[i];
    if (std::abs(found.Distance(p_laser)) > options.gate || beams[i].beam.range < options.min_range)
      continue;
    if (!slam::IsWithinOutline(surface_laser, p_laser)) continue;
    plane.beams.push_back(beams[i].beam);
    plane.slices.push_back(beams[i].slice);
  }
}

}  // namespace

std::vector<CalibrationPlane> FindCalibrationPlanes(std::span<const slam::Scan> scans,
                                                    const ScannerMounting& guess,
                                                    const CalibrationPlanesOptions& options) {
  CheckOptions(options, "planes.");
  std::vector<CalibrationPlane> planes;
  std::size_t first_slice = 0;
  for (const slam::Scan& scan : scans) {
    const slam::PointCloud cloud_laser = slam::ToPointCloud(scan);
    const std::vector<SliceBeam> beams = BeamsOf(scan, first_slice);
    first_slice += scan.sweeps.size();
    const std::vector<slam::PlanarSurface> surfaces = slam::ExtractSurfaces(cloud_laser, options.extract);
    std::vector<slam::PlanarSurface> surfaces_base;
    for (const slam::PlanarSurface& surface : surfaces)
      surfaces_base.push_back(slam::Transformed(PoseOf(guess), surface));
    const std::vector<slam::SurfaceClass> classes = slam::ClassifySurfaces(surfaces_base, options.classify);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const std::optional<PlaneKind> kind = KindOf(classes[i], options.ceilings);
      if (!kind) continue;
      CalibrationPlane plane = PlaneFor(surfaces_base[i], *kind);
      TakeBeams(surfaces[i], beams, cloud_laser, options, plane);
      if (plane.beams.size() >= static_cast<std::size_t>(options.min_points)) planes.push_back(plane);
    }
  }
  return planes;
}

}  // namespace ariadne::drivers
