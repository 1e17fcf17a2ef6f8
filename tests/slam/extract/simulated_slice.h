#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "slam/extract/line_segment.h"
#include "slam/extract/slice_points.h"
#include "slam/geometry/angles.h"
#include "tests/drivers/simulated/box_room.h"
#include "tests/support/random_room.h"

/// Slices of random rooms with all errors of the scanner, and the walls that are in them.
namespace ariadne::slam {

/// A straight part of a surface as the beams sample it, without their errors, in the frame of the slice.
struct TrueWall {
  Eigen::Vector2d from, to;  // where its first and its last beam meet it, from right to left [m]
  double angle = 0.0;        // of the normal, away from the scanner [rad]
  double offset = 0.0;       // [m]
  std::size_t beams = 0;

  double Length() const { return (to - from).norm(); }
};

struct SimulatedSlice {
  std::vector<Eigen::Vector2d> points;
  std::vector<TrueWall> surfaces;  // all that two beams or more meet in succession, less than 0.5 m apart

  /// Those longer than 0.5 m and met by at least 5 beams.
  std::vector<TrueWall> Walls() const {
    std::vector<TrueWall> walls = surfaces;
    std::erase_if(walls, [](const TrueWall& wall) { return wall.Length() <= 0.5 || wall.beams < 5; });
    return walls;
  }
};

inline drivers::RayScene SceneOf(const Room& room) {
  drivers::World world;
  for (const Box3& solid : room.world.solids) {
    world.bodies.push_back(drivers::BoxBody("solid", solid.min(), solid.max()));
  }
  return drivers::RayScene(std::move(world));
}

/// Joins the beams that meet one plane in succession.
inline std::vector<TrueWall> SurfacesOf(const drivers::RayScene& scene, std::span<const drivers::Ray> beams,
                                        const ScannerModel& scanner, double heading) {
  constexpr double kMaxGap = 0.5;
  std::vector<TrueWall> walls;
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const drivers::Hit hit = scene.Cast(beams[b]);
    if (!hit.hit()) continue;
    const double bearing = scanner.first_angle + static_cast<double>(b) * scanner.angle_step;
    const Eigen::Vector2d p = hit.distance * Eigen::Vector2d(std::sin(bearing), -std::cos(bearing));
    const double angle = WrapAngle(std::atan2(-hit.normal_map.y(), -hit.normal_map.x()) - heading);
    const double offset = p.dot(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    const bool goes_on = !walls.empty() && std::abs(WrapAngle(angle - walls.back().angle)) < 1e-6 &&
                         std::abs(offset - walls.back().offset) < 1e-4 &&
                         (p - walls.back().to).norm() < kMaxGap;
    if (!goes_on) walls.push_back({p, p, angle, offset, 0});
    walls.back().to = p;
    ++walls.back().beams;
  }
  std::erase_if(walls, [](const TrueWall& wall) { return wall.beams < 2; });
  return walls;
}

/// A horizontal sweep from a random place in a random room.
inline SimulatedSlice SimulateSlice(std::uint64_t seed, const drivers::AisScannerOptions& options = {}) {
  RandomStream stream = NamedStream(seed, "simulated_slice");
  const Room room = DrawRoom(stream);
  const Eigen::Vector3d viewpoint_map = DrawViewpoint(stream, room);
  const double heading = DrawUniform(stream, -3.0, 3.0);
  Pose3 T_map_base = ToPose3({heading, Eigen::Vector2d::Zero()});
  const drivers::SweepMounting mounting = AisMounting(options);
  T_map_base.translation = viewpoint_map - T_map_base * mounting.T_base_laser.translation;
  const drivers::RayScene scene = SceneOf(room);
  const drivers::Motion standing = drivers::Standing(T_map_base);
  const LaserSweep sweep = TakeAisSweep(scene, standing, 0.0, options, seed, 0);
  const std::vector<drivers::Ray> beams = SweepBeams(mounting, standing, 0.0, 0.0, 0.0);
  return {SlicePoints(mounting.scanner, sweep), SurfacesOf(scene, beams, mounting.scanner, heading)};
}

/// How well a segment stands for a wall.
struct WallError {
  double angle = 0.0;    // [rad]
  double offset = 0.0;   // at the middle of the wall [m]
  double ends[2] = {};   // [m]
  double overlap = 0.0;  // share of the wall's length
};

inline WallError ErrorOfWall(const LineSegment& segment, const TrueWall& wall) {
  const Eigen::Vector2d along = (wall.to - wall.from).normalized();
  const double right = std::max(0.0, along.dot(segment.from - wall.from));
  const double left = std::min(wall.Length(), along.dot(segment.to - wall.from));
  return {std::abs(WrapAngle(segment.angle - wall.angle)),
          std::abs(segment.Distance(0.5 * (wall.from + wall.to))),
          {(segment.from - wall.from).norm(), (segment.to - wall.to).norm()},
          std::max(0.0, left - right) / wall.Length()};
}

/// The segment that covers most of a wall; null where none covers 80 % of it, to 5 deg and 5 cm.
inline const LineSegment* SegmentOf(std::span<const LineSegment> segments, const TrueWall& wall) {
  const LineSegment* best = nullptr;
  for (const LineSegment& segment : segments) {
    const WallError error = ErrorOfWall(segment, wall);
    if (error.angle > RadFromDeg(5.0) || error.offset > 0.05 || error.overlap < 0.8) continue;
    if (best == nullptr || error.overlap > ErrorOfWall(*best, wall).overlap) best = &segment;
  }
  return best;
}

inline std::optional<WallError> FindWall(std::span<const LineSegment> segments, const TrueWall& wall) {
  const LineSegment* const segment = SegmentOf(segments, wall);
  return segment != nullptr ? std::optional(ErrorOfWall(*segment, wall)) : std::nullopt;
}

/// Whether the middle half of a segment lies on one true surface, to 5 deg and 5 cm.
inline bool IsOnSurface(const LineSegment& segment, std::span<const TrueWall> surfaces) {
  const Eigen::Vector2d middle = 0.5 * (segment.from + segment.to);
  return std::ranges::any_of(surfaces, [&](const TrueWall& surface) {
    const Eigen::Vector2d normal(std::cos(surface.angle), std::sin(surface.angle));
    const Eigen::Vector2d along(-normal.y(), normal.x());
    const double half = 0.25 * segment.Length();
    return std::abs(WrapAngle(segment.angle - surface.angle)) < RadFromDeg(5.0) &&
           std::abs(normal.dot(middle) - surface.offset) < 0.05 &&
           along.dot(middle - surface.from) > half && along.dot(surface.to - middle) > half;
  });
}

}  // namespace ariadne::slam
