#include "planning/polygon/scan_polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "planning/polygon/row_crossings.h"

namespace ariadne::planning {
namespace {

constexpr double kHalfWidth = 2.5e-4;  // of what stands for a point [rad]

using Points = std::vector<Eigen::Vector2d>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// From right over ahead to left, with the seam behind: the order that the detectors of ordered points
/// need.
Points PointsByBearingFrom(const slam::HorizontalSlice& slice) {
  struct Seen {
    double bearing, range;
    Eigen::Vector2d p;
  };
  std::vector<Seen> seen;
  const slam::Pose2 T_scan_map = slice.T_map_scan.Inverse();
  for (const Eigen::Vector2d& p_map : slice.points_map) {
    const Eigen::Vector2d p = T_scan_map * p_map;
    seen.push_back({std::atan2(p.y(), p.x()), p.norm(), p});
  }
  std::ranges::stable_sort(seen, [](const Seen& a, const Seen& b) {
    return a.bearing != b.bearing ? a.bearing < b.bearing : a.range < b.range;
  });
  Points points;
  for (const Seen& one : seen) points.push_back(one.p);
  return points;
}

/// Whether a point of the slice lies behind the line, between the bearings of two points on it.
bool SeesThrough(const Points& points, const slam::LineSegment& line, const Eigen::Vector2d& right,
                 const Eigen::Vector2d& left, double depth) {
  return std::ranges::any_of(points, [&](const Eigen::Vector2d& p) {
    return line.Distance(p) > depth && Cross(right, p) > 0.0 && Cross(p, left) > 0.0;
  });
}

/// The parts of a line that the scanner did not see through, from right to left.
void AppendOpaque(const Points& points, const slam::LineSegment& line, const ScanPolygonOptions& options,
                  std::vector<SliceLine>& lines) {
  const Eigen::Vector2d along = (line.to - line.from).normalized();
  std::vector<double> places;  // of the line's points along it
  for (const std::size_t i : line.points) places.push_back(along.dot(points[i] - line.from));
  std::ranges::sort(places);
  const auto append = [&](double begin, double end) {
    if (end <= begin || end - begin < options.min_length) return;
    lines.push_back({line.from + begin * along, line.from + end * along});
  };
  double begin = 0.0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (places[k + 1] - places[k] < options.see_through_gap) continue;
    const Eigen::Vector2d right = line.from + places[k] * along;
    const Eigen::Vector2d left = line.from + places[k + 1] * along;
    if (!SeesThrough(points, line, right, left, options.see_through_depth)) continue;
    append(begin, places[k]);
    begin = places[k + 1];
  }
  append(begin, line.Length());
}

/// A point as a line that is just wide enough to be seen: a millimetre in 2 m.
SliceLine LineAt(const Eigen::Vector2d& p) {
  const Eigen::Vector2d across(-p.y(), p.x());
  return {p - kHalfWidth * across, p + kHalfWidth * across};
}

/// Whether a point is one of a line but for noise: near it, and between the bearings of its ends.
bool BelongsTo(const slam::LineSegment& line, const Eigen::Vector2d& p, double depth) {
  return std::abs(line.Distance(p)) < depth && Cross(line.from, p) > 0.0 && Cross(p, line.to) > 0.0;
}

/// Points that stand for themselves.
void AppendPoints(const Points& points, const std::vector<slam::LineSegment>& segments, double depth,
                  std::vector<SliceLine>& lines) {
  std::vector<bool> explained(points.size(), false);
  for (const slam::LineSegment& segment : segments) {
    for (const std::size_t i : segment.points) explained[i] = true;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto belongs = [&](const slam::LineSegment& line) { return BelongsTo(line, points[i], depth); };
    if (!explained[i] && std::ranges::none_of(segments, belongs)) lines.push_back(LineAt(points[i]));
  }
}

}  // namespace

std::vector<SliceLine> LinesOfScan(const slam::PosedCloud& scan, const ScanPolygonOptions& options) {
  CheckOptions(options, "polygon.");
  slam::HorizontalSlice slice = slam::SliceAt(scan, options.slice);
  if (options.between_rows) {
    std::ranges::copy(RowCrossings(scan, options.slice, options.row_jump),
                      std::back_inserter(slice.points_map));
  }
  const Points points = PointsByBearingFrom(slice);
  const std::vector<slam::LineSegment> segments = slam::DetectLines(points, options.lines);
  std::vector<SliceLine> lines;
  for (const slam::LineSegment& segment : segments) {
    if (segment.Length() > 0.0) AppendOpaque(points, segment, options, lines);
  }
  if (options.keep_points) AppendPoints(points, segments, options.see_through_depth, lines);
  return lines;
}

LabelledPolygon ScanPolygon(const slam::PosedCloud& scan, const ScanPolygonOptions& options) {
  const std::vector<SliceLine> lines = LinesOfScan(scan, options);
  const Eigen::Vector3d ahead = scan.T_map_laser.rotation * Eigen::Vector3d::UnitX();
  const slam::Pose2 T_map_scan{std::atan2(ahead.y(), ahead.x()), scan.T_map_laser.translation.head<2>()};
  return SlicePolygon(lines, T_map_scan, options.polygon);
}

}  // namespace ariadne::planning
