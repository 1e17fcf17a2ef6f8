#include "experiments/studies/plan_step.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "planning/polygon/row_crossings.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kFloorBin = 0.02;   // of heights [m]
constexpr double kOffWall = 0.02;    // nearer marks are of what carries the scanner [m]
constexpr double kLeastMount = 0.2;  // of a laser above the floor [m]

slam::PosedCloud Named(const slam::PosedCloud& scan) { return {scan.name, {}, scan.T_map_laser}; }

/// Its place is the same in the plane, and where it looked.
slam::Pose2 RobotAt(const slam::PosedCloud& scan) { return slam::SliceAt(Named(scan), {}).T_map_scan; }

/// Where the robot has stood is free, though a scan of 180 degrees does not show it.
planning::LabelledPolygon StandAt(const Eigen::Vector2d& p_map,
                                  std::span<const planning::LabelledPolygon> polygons, double radius) {
  constexpr int kCorners = 24;
  for (const planning::Edge& edge : planning::EdgesOf(polygons)) {
    const double wall = planning::Distance(edge, p_map);
    if (edge.seen && wall > kOffWall) radius = std::min(radius, wall - 0.5 * kOffWall);
  }
  return planning::UnseenDisc(p_map, radius, kCorners);
}

}  // namespace

double FloorUnder(std::span<const slam::PosedCloud> scans) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const slam::PosedCloud& scan : scans) lowest = std::min(lowest, scan.T_map_laser.translation.z());
  std::map<long, std::size_t> heights;
  for (const slam::PosedCloud& scan : scans) {
    for (const Eigen::Vector3d& p_laser : scan.cloud_laser.positions) {
      const double z = (scan.T_map_laser * p_laser).z();
      if (z < lowest - kLeastMount) ++heights[std::lround(z / kFloorBin)];
    }
  }
  if (heights.empty()) Fail("the scans show no floor; set from_floor=false and give the height in the map");
  const auto most = std::ranges::max_element(heights, {}, [&](const auto& bin) {
    const auto above = heights.find(bin.first + 1);
    return bin.second + (above == heights.end() ? 0 : above->second);
  });
  return (static_cast<double>(most->first) + 0.5) * kFloorBin;
}

PlanStep PlanNextScan(std::span<const slam::PosedCloud> scans, const PlanStepOptions& options) {
  if (scans.empty()) Fail("there are no scans to plan from");
  for (const slam::PosedCloud& scan : scans) slam::RequireFinite(scan);
  PlanStep step;
  step.slice_z = options.height + (options.from_floor ? FloorUnder(scans) : 0.0);
  planning::ScanPolygonOptions polygon = options.polygon;
  polygon.slice.height = step.slice_z;
  for (const slam::PosedCloud& scan : scans) {
    slam::HorizontalSlice& slice = step.slices.emplace_back(slam::SliceAt(scan, polygon.slice));
    if (polygon.between_rows) {
      std::ranges::copy(planning::RowCrossings(scan, polygon.slice, polygon.row_jump),
                        std::back_inserter(slice.points_map));
    }
    step.lines.push_back(planning::LinesOfScan(scan, polygon));
    step.polygons.push_back(
        planning::SlicePolygon(step.lines.back(), step.slices.back().T_map_scan, polygon.polygon));
  }
  std::vector<planning::LabelledPolygon> parts = step.polygons;
  for (const slam::HorizontalSlice& slice : step.slices) {
    parts.push_back(StandAt(slice.T_map_scan.translation, step.polygons, options.stand_radius));
  }
  step.area = planning::LabelledUnion(parts, options.united);
  if (std::ranges::all_of(step.polygons, &planning::LabelledPolygon::empty))
    Fail("the scans show nothing at the height of {} m", options.height);
  step.T_map_robot = RobotAt(scans.back());
  std::vector<slam::Pose2> T_map_scans;
  for (const slam::HorizontalSlice& slice : step.slices) T_map_scans.push_back(slice.T_map_scan);
  step.plan = planning::PlanNextView(step.area, step.T_map_robot, options.planner,
                                     static_cast<std::uint64_t>(options.seed), T_map_scans);
  return step;
}

}  // namespace ariadne::experiments
