#include "slam/extract/slice_lines.h"

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"
#include "slam/extract/slice_points.h"

namespace ariadne::slam {
namespace {

/// A place in the plane of a slice, where it is by the pitch of a point of the slice.
Eigen::Vector3d InSpace(const Eigen::Vector2d& q, const Eigen::Vector3d& point_laser) {
  const double pitch = std::atan2(point_laser.z(), point_laser.x());
  return {q.x() * std::cos(pitch), q.y(), q.x() * std::sin(pitch)};
}

SpatialLine InSpace(const LineSegment& segment, std::span<const Eigen::Vector2d> points,
                    std::span<const Eigen::Vector3d> positions_laser) {
  std::size_t right = segment.points.front(), left = segment.points.back();
  if ((points[left] - segment.from).norm() < (points[right] - segment.from).norm()) std::swap(right, left);
  SpatialLine line;
  line.from_laser = InSpace(segment.from, positions_laser[right]);
  line.to_laser = InSpace(segment.to, positions_laser[left]);
  line.rms = segment.rms;
  line.points = segment.points.size();
  line.explained_laser.reserve(line.points);
  for (const std::size_t i : segment.points) line.explained_laser.push_back(positions_laser[i]);
  return line;
}

}  // namespace

std::vector<SpatialLine> SpatialLines(const PointCloud& cloud_laser, std::size_t slice,
                                      const LineOptions& options) {
  const std::vector<Eigen::Vector2d> points = SlicePoints(cloud_laser, slice);
  std::vector<LineSegment> segments = DetectLines(points, options);
  std::ranges::stable_sort(segments, {}, [](const LineSegment& s) { return s.points.front(); });
  const auto positions =
      std::span(cloud_laser.positions).subspan(cloud_laser.slice_begin[slice], points.size());
  std::vector<SpatialLine> lines;
  lines.reserve(segments.size());
  for (const LineSegment& segment : segments) {
    lines.push_back(InSpace(segment, points, positions));
    lines.back().slice = slice;
  }
  return lines;
}

std::vector<std::vector<SpatialLine>> SliceLines(const PointCloud& cloud_laser,
                                                 const LineOptions& options) {
  RequireSlices(cloud_laser, "finding lines");
  std::vector<std::vector<SpatialLine>> lines;
  for (std::size_t slice = 0; slice < cloud_laser.slice_begin.size(); ++slice) {
    lines.push_back(SpatialLines(cloud_laser, slice, options));
  }
  return lines;
}

PointCloud EdgePointCloud(const PointCloud& cloud_laser, const LineOptions& options) {
  RequireSlices(cloud_laser, "finding edge points");
  PointCloud edges;
  for (const std::vector<SpatialLine>& lines : SliceLines(cloud_laser, options)) {
    edges.slice_begin.push_back(edges.size());
    for (const SpatialLine& line : lines) {
      edges.positions.push_back(line.from_laser);
      edges.positions.push_back(line.to_laser);
    }
  }
  return edges;
}

void RequireSlices(const PointCloud& cloud_laser, std::string_view purpose) {
  if (cloud_laser.empty() || cloud_laser.organized()) return;
  Fail(
      "{} needs the slices of a scan, and this cloud has none; keep the points in the order of the "
      "scanner, or take a method that does without slices",
      purpose);
}

}  // namespace ariadne::slam
