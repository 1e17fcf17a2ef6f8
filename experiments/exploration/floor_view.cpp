#include "experiments/exploration/floor_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "planning/polygon/slice_polygon.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using planning::SliceLine;
constexpr double kOnWall = 1e-3;  // what the docstring promises [m]

double Cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The part of a line within a disc around the origin.
std::optional<SliceLine> WithinRange(const SliceLine& line, double range) {
  const Eigen::Vector2d d = line.to_scan - line.from_scan;
  const double a = d.squaredNorm(), b = line.from_scan.dot(d);
  const double c = line.from_scan.squaredNorm() - range * range;
  const double root = b * b - a * c;
  if (root <= 0.0 || a == 0.0) return {};
  const double begin = std::max(0.0, (-b - std::sqrt(root)) / a);
  const double end = std::min(1.0, (-b + std::sqrt(root)) / a);
  if (begin >= end) return {};
  return SliceLine{line.from_scan + begin * d, line.from_scan + end * d};
}

/// The part of a line to the left of a direction from the origin.
std::optional<SliceLine> LeftOf(const SliceLine& line, double bearing) {
  const Eigen::Vector2d u(std::cos(bearing), std::sin(bearing));
  const double from = Cross2(u, line.from_scan), to = Cross2(u, line.to_scan);
  if (from <= 0.0 && to <= 0.0) return {};
  if (from >= 0.0 && to >= 0.0) return line;
  const Eigen::Vector2d cut = line.from_scan + from / (from - to) * (line.to_scan - line.from_scan);
  return from > 0.0 ? SliceLine{line.from_scan, cut} : SliceLine{cut, line.to_scan};
}

/// The part between two bearings that are at most half a turn apart.
std::optional<SliceLine> Between(const SliceLine& line, double right, double left) {
  const auto part = LeftOf(line, right);
  return part ? LeftOf(*part, left + std::numbers::pi) : part;
}

void AppendInView(const SliceLine& line, double half_view, std::vector<SliceLine>& lines) {
  if (half_view >= std::numbers::pi) {
    lines.push_back(line);
  } else if (half_view <= 0.5 * std::numbers::pi) {
    if (const auto part = Between(line, -half_view, half_view)) lines.push_back(*part);
  } else {
    if (const auto part = Between(line, -half_view, 0.0)) lines.push_back(*part);
    if (const auto part = Between(line, 0.0, half_view)) lines.push_back(*part);
  }
}

std::vector<SliceLine> LinesInView(const Floor& floor, const slam::Pose2& T_map_scan,
                                   const FloorScannerOptions& options) {
  const slam::Pose2 T_scan_map = T_map_scan.Inverse();
  const double half_view = 0.5 * slam::RadFromDeg(options.field_of_view);
  std::vector<SliceLine> lines;
  for (const FloorWall& face : floor.faces) {
    const auto line = WithinRange({T_scan_map * face.from, T_scan_map * face.to}, options.max_range);
    if (line) AppendInView(*line, half_view, lines);
  }
  return lines;
}

}  // namespace

FloorView ViewFloor(const Floor& floor, const slam::Pose2& T_map_scan, const FloorScannerOptions& options) {
  const std::vector<SliceLine> lines = LinesInView(floor, T_map_scan, options);
  planning::SlicePolygonOptions polygon;
  polygon.free_range = floor.enclosed ? options.max_range : 0.0;
  polygon.field_of_view = options.field_of_view;
  if (options.field_of_view >= 360.0) polygon.closure = planning::PolygonClosure::kChord;
  return {T_map_scan, planning::VisiblePieces(lines), planning::SlicePolygon(lines, T_map_scan, polygon)};
}

bool IsSeen(const FloorView& view, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d p = view.T_map_scan.Inverse() * p_map;
  const double bearing = std::atan2(p.y(), p.x());
  const auto next = std::ranges::upper_bound(view.pieces, bearing, {}, &planning::VisiblePiece::right);
  if (next == view.pieces.begin()) return false;
  const planning::VisiblePiece& piece = *std::prev(next);
  if (bearing > piece.left) return false;
  const Eigen::Vector2d along = (piece.left_scan - piece.right_scan).normalized();
  return std::abs(Cross2(along, p - piece.right_scan)) < kOnWall;
}

}  // namespace ariadne::experiments
