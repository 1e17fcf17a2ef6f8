#include "slam/map/map_line.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ariadne::slam {
namespace {

/// The moments of all points of both.
LineMoments Joined(const LineMoments& a, const LineMoments& b) {
  LineMoments joined;
  joined.weight = a.weight + b.weight;
  joined.mean = (a.weight * a.mean + b.weight * b.mean) / joined.weight;
  const Eigen::Vector2d apart = b.mean - a.mean;
  joined.scatter = a.scatter + b.scatter + a.weight * b.weight / joined.weight * apart * apart.transpose();
  return joined;
}

/// Of the two directions of a line the one that agrees with another line's.
Eigen::Vector2d AlongAs(const Eigen::Vector2d& tangent, const Eigen::Vector2d& other) {
  return tangent.dot(other) < 0.0 ? Eigen::Vector2d(-tangent) : tangent;
}

double DistanceFromLine(const Eigen::Vector2d& p_map, const MapLine& line) {
  return std::abs(line.Normal().dot(p_map - line.from_map));
}

/// How far apart two lines are along the direction of the first; negative where they overlap [m].
double GapBetween(const MapLine& line, const MapLine& other) {
  const Eigen::Vector2d tangent = line.Tangent();
  const double a = tangent.dot(other.from_map - line.from_map);
  const double b = tangent.dot(other.to_map - line.from_map);
  return std::max(std::min(a, b) - line.Length(), -std::max(a, b));
}

std::vector<std::size_t> United(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

/// One pass over the lines; each finds its place among those before it.
std::vector<MapLine> MergeOnce(const std::vector<MapLine>& lines, const MergeLinesOptions& options) {
  std::vector<MapLine> merged;
  for (const MapLine& line : lines) {
    const auto same =
        std::ranges::find_if(merged, [&](const MapLine& other) { return Coincide(line, other, options); });
    if (same == merged.end()) {
      merged.push_back(line);
    } else {
      *same = Merged(*same, line);
    }
  }
  return merged;
}

}  // namespace

Eigen::Vector2d MapLine::Normal() const {
  const Eigen::Vector2d tangent = Tangent();
  return {tangent.y(), -tangent.x()};
}

double MapLine::Rms() const {
  const Eigen::Vector2d normal = Normal();
  return std::sqrt(std::max(0.0, normal.dot(moments_map.scatter * normal)) / moments_map.weight);
}

bool Coincide(const MapLine& a, const MapLine& b, const MergeLinesOptions& options) {
  const MapLine& longer = a.Length() >= b.Length() ? a : b;
  const MapLine& shorter = a.Length() >= b.Length() ? b : a;
  return longer.Normal().dot(shorter.Normal()) >= std::cos(options.max_angle) &&
         DistanceFromLine(shorter.from_map, longer) <= options.max_distance &&
         DistanceFromLine(shorter.to_map, longer) <= options.max_distance &&
         GapBetween(longer, shorter) <= options.max_gap;
}

MapLine Merged(const MapLine& a, const MapLine& b) {
  MapLine merged;
  merged.moments_map = Joined(a.moments_map, b.moments_map);
  const Eigen::Vector2d normal = merged.moments_map.Normal();
  const MapLine& longer = a.Length() >= b.Length() ? a : b;
  const Eigen::Vector2d tangent = AlongAs({-normal.y(), normal.x()}, longer.Tangent());
  double right = 0.0, left = 0.0;
  for (const Eigen::Vector2d& end : {a.from_map, a.to_map, b.from_map, b.to_map}) {
    const double along = tangent.dot(end - merged.moments_map.mean);
    right = std::min(right, along);
    left = std::max(left, along);
  }
  merged.from_map = merged.moments_map.mean + right * tangent;
  merged.to_map = merged.moments_map.mean + left * tangent;
  merged.points = a.points + b.points;
  merged.scans = United(a.scans, b.scans);
  return merged;
}

std::vector<MapLine> MergeLines(std::vector<MapLine> lines, const MergeLinesOptions& options) {
  CheckOptions(options, "merge.");
  std::size_t before = 0;
  do {
    before = lines.size();
    std::ranges::stable_sort(lines, std::ranges::greater(), &MapLine::points);
    lines = MergeOnce(lines, options);
  } while (lines.size() < before);
  return lines;
}

}  // namespace ariadne::slam
