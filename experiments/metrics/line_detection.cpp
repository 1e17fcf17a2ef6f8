#include "experiments/metrics/line_detection.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using slam::LineSegment;

constexpr double kMaxGap = 0.5;                      // between beams that meet one wall [m]
constexpr double kLongLine = 0.5;                    // shorter walls and segments do not count [m]
constexpr std::size_t kManyBeams = 5;                // fewer say little of a wall
constexpr double kMaxAngle = slam::RadFromDeg(5.0);  // of a segment that stands for a wall
constexpr double kMaxOffset = 0.05;                  // of the same [m]
constexpr double kMinOverlap = 0.8;                  // of the same, share of the wall

bool GoesOn(const TrueWall& wall, const Eigen::Vector2d& p, double angle, double offset) {
  return std::abs(slam::WrapAngle(angle - wall.angle)) < 1e-6 && std::abs(offset - wall.offset) < 1e-4 &&
         (p - wall.to).norm() < kMaxGap;
}

double Share(std::size_t part, std::size_t all) {
  return all == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(all);
}

void Append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

std::vector<TrueWall> VisibleWalls(const drivers::RayScene& scene, std::span<const drivers::Ray> beams,
                                   const slam::ScannerModel& scanner,
                                   const Eigen::Quaterniond& R_map_slice) {
  std::vector<TrueWall> walls;
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const drivers::Hit hit = scene.Cast(beams[b]);
    if (!hit.hit()) continue;
    const double bearing = scanner.first_angle + static_cast<double>(b) * scanner.angle_step;
    const Eigen::Vector2d p = hit.distance * Eigen::Vector2d(std::sin(bearing), -std::cos(bearing));
    const Eigen::Vector3d normal = R_map_slice.conjugate() * hit.normal_map;
    const double angle = slam::WrapAngle(std::atan2(-normal.y(), -normal.x()));
    const double offset = p.dot(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    if (walls.empty() || !GoesOn(walls.back(), p, angle, offset)) walls.push_back({p, p, angle, offset, 0});
    walls.back().to = p;
    ++walls.back().beams;
  }
  std::erase_if(walls, [](const TrueWall& wall) { return wall.beams < 2; });
  return walls;
}

WallError ErrorOfWall(const LineSegment& segment, const TrueWall& wall) {
  const Eigen::Vector2d along = (wall.to - wall.from).normalized();
  const double right = std::max(0.0, along.dot(segment.from - wall.from));
  const double left = std::min(wall.Length(), along.dot(segment.to - wall.from));
  return {std::abs(slam::WrapAngle(segment.angle - wall.angle)),
          std::abs(segment.Distance(0.5 * (wall.from + wall.to))),
          {(segment.from - wall.from).norm(), (segment.to - wall.to).norm()},
          std::max(0.0, left - right) / wall.Length()};
}

const LineSegment* SegmentOf(std::span<const LineSegment> segments, const TrueWall& wall) {
  const LineSegment* best = nullptr;
  for (const LineSegment& segment : segments) {
    const WallError error = ErrorOfWall(segment, wall);
    if (error.angle > kMaxAngle || error.offset > kMaxOffset || error.overlap < kMinOverlap) continue;
    if (best == nullptr || error.overlap > ErrorOfWall(*best, wall).overlap) best = &segment;
  }
  return best;
}

bool IsOnWall(const LineSegment& segment, std::span<const TrueWall> walls) {
  const Eigen::Vector2d middle = 0.5 * (segment.from + segment.to);
  return std::ranges::any_of(walls, [&](const TrueWall& wall) {
    const Eigen::Vector2d normal(std::cos(wall.angle), std::sin(wall.angle));
    const Eigen::Vector2d along(-normal.y(), normal.x());
    const double half = 0.25 * segment.Length();
    return std::abs(slam::WrapAngle(segment.angle - wall.angle)) < kMaxAngle &&
           std::abs(normal.dot(middle) - wall.offset) < kMaxOffset &&
           along.dot(middle - wall.from) > half && along.dot(wall.to - middle) > half;
  });
}

bool IsToBeFound(const TrueWall& wall) { return wall.Length() > kLongLine && wall.beams >= kManyBeams; }

double LineScore::Recall() const { return Share(angles.size(), walls); }

double LineScore::Precision() const { return Share(true_ones, segments); }

double LineScore::ShareOfEndsWithin(double distance) const {
  const auto within = std::ranges::count_if(ends, [&](double end) { return end <= distance; });
  return Share(static_cast<std::size_t>(within), ends.size());
}

LineScore& LineScore::operator+=(const LineScore& other) {
  walls += other.walls;
  segments += other.segments;
  true_ones += other.true_ones;
  Append(angles, other.angles);
  Append(offsets, other.offsets);
  Append(ends, other.ends);
  return *this;
}

LineScore ScoreLines(std::span<const LineSegment> segments, std::span<const TrueWall> walls) {
  LineScore score;
  for (const TrueWall& wall : walls) {
    if (!IsToBeFound(wall)) continue;
    ++score.walls;
    const LineSegment* const segment = SegmentOf(segments, wall);
    if (segment == nullptr) continue;
    const WallError error = ErrorOfWall(*segment, wall);
    score.angles.push_back(error.angle);
    score.offsets.push_back(error.offset);
    score.ends.insert(score.ends.end(), {error.ends[0], error.ends[1]});
  }
  for (const LineSegment& segment : segments) {
    if (segment.Length() <= kLongLine) continue;
    ++score.segments;
    if (IsOnWall(segment, walls)) ++score.true_ones;
  }
  return score;
}

}  // namespace ariadne::experiments
