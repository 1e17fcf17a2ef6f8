#include "experiments/exploration/scan_loop_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kRoundStep = std::numbers::pi / 8.0;  // of an arc [rad]
constexpr double kOffWalls = 0.01;                     // so that no known place reaches through a wall [m]
constexpr double kRobotHalf = 0.28;   // within the robot's own outline, whatever seems to stand there [m]
constexpr double kNearScanner = 0.2;  // covered by where the robot stands [m]

using planning::LabelledPolygon;
using planning::LabelledRing;

double DistanceToPiece(const Eigen::Vector2d& p, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d d = to - from;
  const double squared = d.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - from).dot(d) / squared, 0.0, 1.0) : 0.0;
  return (p - from - share * d).norm();
}

double DistanceToRing(const Eigen::Vector2d& p, const LabelledRing& ring, bool seen_only) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (seen_only && !ring[i].seen) continue;
    nearest = std::min(nearest, DistanceToPiece(p, ring[i].p_map, ring[(i + 1) % ring.size()].p_map));
  }
  return nearest;
}

/// Corners on an arc, counterclockwise, from one angle to another [rad]; both ends included.
void AppendArc(const Eigen::Vector2d& center, double radius, double from, double to, bool seen,
               LabelledRing& ring) {
  const int pieces = std::max(1, static_cast<int>(std::lround((to - from) / kRoundStep)));
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    ring.push_back({center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), seen});
  }
}

/// The hull of two discs.
LabelledRing HullOfDiscs(const Eigen::Vector2d& rear, const Eigen::Vector2d& front, double radius) {
  const Eigen::Vector2d ahead = front - rear;
  const double heading = std::atan2(ahead.y(), ahead.x()), quarter = 0.5 * std::numbers::pi;
  LabelledRing ring;
  AppendArc(front, radius, heading - quarter, heading + quarter, false, ring);
  AppendArc(rear, radius, heading + quarter, heading + 3.0 * quarter, false, ring);
  return ring;
}

/// Nothing counts as free between two bearings where a wide gap shows nothing: an unseen edge across it
/// becomes two that meet near the scanner. The polygon is star-shaped about the scanner, and stays so.
LabelledPolygon WithoutWideGaps(LabelledPolygon polygon, const Eigen::Vector2d& scanner, double max_gap) {
  LabelledRing ring;
  const LabelledRing& outer = polygon.outer;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    ring.push_back(outer[i]);
    if (outer[i].seen) continue;
    const Eigen::Vector2d from = outer[i].p_map - scanner;
    const Eigen::Vector2d to = outer[(i + 1) % outer.size()].p_map - scanner;
    if (std::min(from.norm(), to.norm()) < kNearScanner) continue;  // it ends at the scanner already
    const double gap = std::acos(std::clamp(from.dot(to) / (from.norm() * to.norm()), -1.0, 1.0));
    if (gap < max_gap) continue;
    const Eigen::Vector2d middle = (from.normalized() + to.normalized()).normalized();
    ring.push_back({scanner + kNearScanner * middle, false});
  }
  polygon.outer = std::move(ring);
  return polygon;
}

}  // namespace

slam::Pose2 FromAbove(const slam::Pose3& pose) {
  const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitX();
  return {std::atan2(ahead.y(), ahead.x()), pose.translation.head<2>()};
}

double DistanceToEdges(const Eigen::Vector2d& p_map, std::span<const LabelledPolygon> area,
                       bool seen_only) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const LabelledPolygon& polygon : area) {
    nearest = std::min(nearest, DistanceToRing(p_map, polygon.outer, seen_only));
    for (const LabelledRing& hole : polygon.holes)
      nearest = std::min(nearest, DistanceToRing(p_map, hole, seen_only));
  }
  return nearest;
}

ScanLoopArea::ScanLoopArea(const ScanLoopAreaOptions& options, std::vector<double> heights,
                           const slam::Pose3& T_base_laser)
    : options_(options),
      heights_(std::move(heights)),
      T_base_laser_(T_base_laser),
      lines_(heights_.size()) {
  CheckOptions(options, "area.");
}

void ScanLoopArea::AddScan(const slam::PosedCloud& scan) {
  for (std::size_t h = 0; h < heights_.size(); ++h) {
    planning::ScanPolygonOptions polygon = options_.polygon;
    polygon.slice.height = heights_[h];
    lines_[h].push_back(planning::LinesOfScan(scan, polygon));
  }
}

std::vector<LabelledPolygon> ScanLoopArea::At(std::size_t height,
                                              std::span<const slam::Pose3> T_map_laser) const {
  std::vector<LabelledPolygon> parts;
  for (std::size_t i = 0; i < T_map_laser.size(); ++i) {
    LabelledPolygon polygon =
        planning::SlicePolygon(lines_[height][i], FromAbove(T_map_laser[i]), options_.polygon.polygon);
    if (polygon.empty()) continue;
    parts.push_back(WithoutWideGaps(std::move(polygon), FromAbove(T_map_laser[i]).translation,
                                    slam::RadFromDeg(options_.max_gap)));
  }
  std::vector<LabelledPolygon> stands;
  for (const slam::Pose3& pose : T_map_laser) stands.push_back(Stand(pose, parts));
  parts.insert(parts.end(), stands.begin(), stands.end());
  return planning::LabelledUnion(parts, options_.united);
}

std::vector<LabelledPolygon> ScanLoopArea::ToLookCloser(std::span<const LabelledPolygon> area,
                                                        std::size_t height,
                                                        std::span<const slam::Pose3> T_map_laser) const {
  std::vector<planning::SightedLine> lines;
  for (std::size_t i = 0; i < T_map_laser.size(); ++i) {
    const slam::Pose2 T_map_scan = FromAbove(T_map_laser[i]);
    for (const planning::SliceLine& line : lines_[height][i])
      lines.push_back({T_map_scan * line.from_scan, T_map_scan * line.to_scan, T_map_scan.translation});
  }
  return planning::WithSparseUnseen(area, lines, options_.sparse);
}

/// Where the robot stood is free, whether it has looked there or not.
LabelledPolygon ScanLoopArea::Stand(const slam::Pose3& T_map_laser,
                                    std::span<const LabelledPolygon> scans) const {
  const Eigen::Vector2d scanner = FromAbove(T_map_laser).translation;
  const Eigen::Vector2d middle = FromAbove(T_map_laser * T_base_laser_.Inverse()).translation;
  double walls = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : {middle, Eigen::Vector2d(0.5 * (middle + scanner)), scanner})
    walls = std::min(walls, DistanceToEdges(p, scans, true));
  const double radius = std::max(kRobotHalf, std::min(options_.stand_radius, walls - kOffWalls));
  return {HullOfDiscs(middle, scanner, radius), {}};
}

}  // namespace ariadne::experiments
