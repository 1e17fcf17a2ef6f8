#include "slam/map/line_map.h"

#include <algorithm>
#include <cmath>

#include "slam/map/layer_names.h"
#include "slam/map/scan_layers.h"

namespace ariadne::slam {
namespace {

constexpr Rgb kLineColor{0, 0, 0};

/// Seen from the laser, in the order of the bearings: from right over ahead to left, with the seam behind.
std::vector<Eigen::Vector2d> PointsByBearing(const HorizontalSlice& slice) {
  struct Seen {
    double bearing, range;
    Eigen::Vector2d p;
  };
  std::vector<Seen> seen;
  const Pose2 T_scan_map = slice.T_map_scan.Inverse();
  for (const Eigen::Vector2d& p_map : slice.points_map) {
    const Eigen::Vector2d p = T_scan_map * p_map;
    seen.push_back({std::atan2(p.y(), p.x()), p.norm(), p});
  }
  std::ranges::stable_sort(seen, [](const Seen& a, const Seen& b) {
    return a.bearing != b.bearing ? a.bearing < b.bearing : a.range < b.range;
  });
  std::vector<Eigen::Vector2d> points;
  for (const Seen& one : seen) points.push_back(one.p);
  return points;
}

const SliceNoise& NoiseOf(const LineOptions& options) {
  switch (options.method) {
    case LineMethod::kLengthRatio:
      return options.length_ratio.noise;
    case LineMethod::kHough:
      return options.hough.noise;
    case LineMethod::kSplitAndMerge:
      break;
  }
  return options.split_and_merge.noise;
}

LineMoments InMap(const Pose2& T_map_scan, const LineMoments& moments) {
  const Eigen::Matrix2d R = T_map_scan.RotationMatrix();
  return {moments.weight, T_map_scan * moments.mean, R * moments.scatter * R.transpose()};
}

MapLine ToMapLine(const LineSegment& segment, std::span<const Eigen::Vector2d> points,
                  const SliceNoise& noise, const Pose2& T_map_scan, std::size_t scan) {
  WeightedPoints weighted{points, segment.points, {}};
  for (const std::size_t i : segment.points) {
    weighted.weights.push_back(std::pow(SigmaAcross(segment.Normal(), points[i], noise), -2));
  }
  MapLine line;
  line.from_map = T_map_scan * segment.from;
  line.to_map = T_map_scan * segment.to;
  line.moments_map = InMap(T_map_scan, Gather(weighted));
  line.points = segment.points.size();
  line.scans = {scan};
  return line;
}

}  // namespace

LineMap MakeLineMap(std::span<const PosedCloud> scans, const LineMapOptions& options) {
  CheckOptions(options, "line_map.");
  LineMap map{SlicesAt(scans, options.slice), {}};
  for (std::size_t scan = 0; scan < map.slices.size(); ++scan) {
    const HorizontalSlice& slice = map.slices[scan];
    const std::vector<Eigen::Vector2d> points = PointsByBearing(slice);
    for (const LineSegment& segment : DetectLines(points, options.lines)) {
      if (segment.Length() < options.min_length || segment.Length() == 0.0) continue;
      map.lines.push_back(ToMapLine(segment, points, NoiseOf(options.lines), slice.T_map_scan, scan));
    }
  }
  map.lines = MergeLines(std::move(map.lines), options.merge);
  return map;
}

Drawing DrawingOf(const LineMap& map) {
  const auto at_ground = [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0.0); };
  std::vector<std::string> names;
  for (const HorizontalSlice& slice : map.slices) names.push_back(slice.name);
  const std::vector<std::string> layer_names = LayerNames("points_", names);
  Drawing drawing;
  for (std::size_t scan = 0; scan < map.slices.size(); ++scan) {
    if (map.slices[scan].points_map.empty()) continue;
    DrawingLayer layer{layer_names[scan], ScanColor(scan), {}, {}, {}};
    for (const Eigen::Vector2d& p_map : map.slices[scan].points_map)
      layer.points.push_back(at_ground(p_map));
    drawing.layers.push_back(std::move(layer));
  }
  DrawingLayer lines{"lines", kLineColor, {}, {}, {}};
  for (const MapLine& line : map.lines) {
    lines.lines.push_back({{at_ground(line.from_map), at_ground(line.to_map)}, false});
  }
  drawing.layers.push_back(std::move(lines));
  return drawing;
}

}  // namespace ariadne::slam
