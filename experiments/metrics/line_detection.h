#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/simulated/ray_scene.h"
#include "slam/extract/line_segment.h"
#include "slam/scan/scan.h"

namespace ariadne::experiments {

/// A straight part of a surface as the beams of a slice sample it, without their errors, in the frame of
/// the slice.
struct TrueWall {
  Eigen::Vector2d from, to;  // where its first and its last beam meet it, from right to left [m]
  double angle = 0.0;        // of the normal, away from the scanner [rad]
  double offset = 0.0;       // [m]
  std::size_t beams = 0;

  double Length() const { return (to - from).norm(); }
};

/// All that two beams or more of a slice meet in succession in one plane, less than 0.5 m apart. The slice
/// is one that does not tilt while it is swept; `R_map_slice` turns its frame into the map's.
std::vector<TrueWall> VisibleWalls(const drivers::RayScene& scene, std::span<const drivers::Ray> beams,
                                   const slam::ScannerModel& scanner,
                                   const Eigen::Quaterniond& R_map_slice);

/// How well a segment stands for a wall.
struct WallError {
  double angle = 0.0;    // [rad]
  double offset = 0.0;   // at the middle of the wall [m]
  double ends[2] = {};   // [m]
  double overlap = 0.0;  // share of the wall's length
};

WallError ErrorOfWall(const slam::LineSegment& segment, const TrueWall& wall);

/// The segment that covers most of a wall; null where none covers 80 % of it, to 5 deg and 5 cm.
const slam::LineSegment* SegmentOf(std::span<const slam::LineSegment> segments, const TrueWall& wall);

/// Whether the middle half of a segment lies on one true wall, to 5 deg and 5 cm.
bool IsOnWall(const slam::LineSegment& segment, std::span<const TrueWall> walls);

/// How well the segments of slices stand for the walls; sums over slices by +=.
struct LineScore {
  std::size_t walls = 0;                      // to be found: longer than 0.5 m and met by 5 beams or more
  std::size_t segments = 0;                   // longer than 0.5 m
  std::size_t true_ones = 0;                  // of these: on a wall of any length
  std::vector<double> angles, offsets, ends;  // errors of the walls found [rad, m, m]; two ends each

  double Recall() const;
  double Precision() const;
  /// Of the ends of walls that were found.
  double ShareOfEndsWithin(double distance) const;
  LineScore& operator+=(const LineScore& other);
};

LineScore ScoreLines(std::span<const slam::LineSegment> segments, std::span<const TrueWall> walls);

/// Whether a detector is expected to find the wall.
bool IsToBeFound(const TrueWall& wall);

}  // namespace ariadne::experiments
