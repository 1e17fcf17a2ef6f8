#include "experiments/studies/fig_10.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/plan_picture.h"
#include "experiments/report/table.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using control::ApproachBehaviour;
using control::ApproachPlan;
using slam::Pose2;

constexpr Rgb kBoxColor{176, 112, 40};
constexpr Rgb kBlockedColor{150, 156, 166};
constexpr double kEdgeSpacing = 0.05;      // between the points that unseen edges are tested as [m]
constexpr double kFootprintSpacing = 0.6;  // between outlines of the robot that are drawn [m]

/// From the robot's frame to the farthest corner of its margin [m].
double ReachOf(const control::RectangleOptions& robot) {
  return std::hypot(0.5 * robot.length + std::abs(robot.centre_ahead) + robot.margin,
                    0.5 * robot.width + robot.margin);
}

/// What stands in the way: boxes of objects, walls that are seen, and the edges of what is known, but for
/// where the robot stands.
control::GroundObstacles ObstaclesOf(const slam::SurfaceModel& model, const PlanStep& step, double floor,
                                     const Fig10Options& options) {
  control::GroundObstacles obstacles;
  for (const slam::ObjectBox& object : model.objects) {
    const Eigen::Vector3d low = object.box.min(), high = object.box.max();
    if (high.z() < floor + options.lowest || low.z() > floor + options.highest) continue;
    const Eigen::Vector2d centre = 0.5 * (low + high).head<2>();
    obstacles.outlines.push_back(
        control::BoxOutline({0.0, centre}, high.x() - low.x(), high.y() - low.y()));
  }
  for (const Segment& wall : SegmentsOf(step.area, true))
    obstacles.outlines.push_back({wall.first, wall.second});
  const double reach = ReachOf(options.drive.robot);
  for (const Segment& edge : SegmentsOf(step.area, false)) {
    const double length = (edge.second - edge.first).norm();
    const int count = static_cast<int>(std::ceil(length / kEdgeSpacing));
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector2d p = edge.first + (edge.second - edge.first) * i / std::max(count, 1);
      if ((p - step.T_map_robot.translation).norm() > reach) obstacles.points.push_back(p);
    }
  }
  return obstacles;
}

struct Drive {
  Pose2 start, goal;
  ApproachPlan plan;
};

struct Drives {
  std::vector<Drive> shown;                  // one per behaviour that is needed somewhere
  std::array<int, 4> counts = {0, 0, 0, 0};  // per behaviour, and where none is free
};

/// From the scan's place, at several headings, to the views, the best first.
Drives DrivesOf(const PlanStep& step, const control::GroundObstacles& obstacles,
                const Fig10Options& options) {
  std::vector<planning::View> views = step.plan.views;
  std::ranges::stable_sort(
      views, [](const planning::View& a, const planning::View& b) { return a.value > b.value; });
  Drives drives;
  std::array<bool, 3> has{};
  for (int k = 0; k < options.headings; ++k) {
    Pose2 start = step.T_map_robot;
    start.angle = slam::WrapAngle(start.angle + 2.0 * std::numbers::pi * k / options.headings);
    for (const planning::View& view : views) {
      const Pose2 goal{view.direction, view.p_map};
      ApproachPlan plan = PlanApproach(start, goal, obstacles, options.drive);
      const std::size_t index = plan.IsFree() ? static_cast<std::size_t>(plan.behaviour()) : 3;
      ++drives.counts[index];
      if (index == 3 || has[index]) continue;
      has[index] = true;
      drives.shown.push_back({start, goal, std::move(plan)});
    }
  }
  std::ranges::stable_sort(
      drives.shown, [](const Drive& a, const Drive& b) { return a.plan.behaviour() < b.plan.behaviour(); });
  return drives;
}

std::vector<Segment> Outline(const slam::Ring& ring) {
  std::vector<Segment> lines;
  for (std::size_t k = 0; k < ring.size(); ++k) lines.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  return lines;
}

std::vector<Segment> RobotOutline(const Pose2& T_map_robot, const control::RectangleOptions& robot) {
  const Pose2 centre{T_map_robot.angle, T_map_robot * Eigen::Vector2d(robot.centre_ahead, 0.0)};
  return Outline(control::BoxOutline(centre, robot.length, robot.width));
}

std::vector<Segment> WayAlong(const std::vector<control::ApproachSample>& samples) {
  std::vector<Segment> way;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Segment piece(samples[k - 1].T_map_robot.translation, samples[k].T_map_robot.translation);
    if (piece.first != piece.second) way.push_back(piece);
  }
  return way;
}

/// Outlines of the robot along its way.
std::vector<Segment> FootprintsAlong(const ApproachPlan& plan, const control::RectangleOptions& robot) {
  std::vector<Segment> lines;
  double since = kFootprintSpacing;
  for (std::size_t k = 0; k < plan.poses.size(); ++k) {
    if (k > 0) since += (plan.poses[k].translation - plan.poses[k - 1].translation).norm();
    if (since < kFootprintSpacing && k + 1 < plan.poses.size()) continue;
    for (const Segment& line : RobotOutline(plan.poses[k], robot)) lines.push_back(line);
    since = 0.0;
  }
  return lines;
}

std::string CaptionOf(ApproachBehaviour behaviour) {
  switch (behaviour) {
    case ApproachBehaviour::kController:
      return "(a) The controller";
    case ApproachBehaviour::kTurnFirst:
      return "(b) Turn first, then the controller";
    case ApproachBehaviour::kTurnStraightTurn:
      return "(c) Turn, straight, turn";
  }
  return "";
}

Image DrivePanel(const Drive& drive, const PlanStep& step, const control::GroundObstacles& obstacles,
                 const Fig10Options& options) {
  const std::vector<Eigen::Vector2d> places = CornersOf(step.area);
  PlanCanvas canvas(places, options.width);
  canvas.Area(step.area);
  canvas.Edges(step.area);
  for (const slam::Ring& outline : obstacles.outlines) {
    if (outline.size() > 2) canvas.Lines(Outline(outline), {.color = kBoxColor, .width = 3.0});
  }
  for (const control::ApproachAttempt& attempt : drive.plan.attempts) {
    if (!attempt.hit) continue;
    const auto blocked =
        SimulateApproach(drive.start, drive.goal, options.drive.approach, attempt.behaviour);
    canvas.Lines(WayAlong(blocked.samples), {.color = kBlockedColor, .width = 2.0});
    canvas.Lines(RobotOutline(attempt.hit->T_map_robot, options.drive.robot),
                 {.color = kBlockedColor, .width = 2.0});
  }
  canvas.Lines(FootprintsAlong(drive.plan, options.drive.robot),
               {.color = PlanColors::kCandidate, .width = 1.0, .opacity = 0.5});
  canvas.Lines(WayAlong(drive.plan.trajectory.samples), {.color = PlanColors::kCandidate, .width = 3.0});
  canvas.Robot(drive.start, PlanColors::kRobot);
  canvas.Robot(drive.goal, PlanColors::kView);
  return canvas.Finished(CaptionOf(drive.plan.behaviour()));
}

std::vector<std::string> RowOf(const Drive& drive) {
  const ApproachPlan& plan = drive.plan;
  const auto pose = [](const Pose2& p) {
    return fmt::format("{:.2f} {:.2f} {:.0f}", p.translation.x(), p.translation.y(),
                       slam::DegFromRad(p.angle));
  };
  return {std::string(NameOf(plan.behaviour())),
          pose(drive.start),
          pose(drive.goal),
          Exact((drive.goal.translation - drive.start.translation).norm()),
          Exact(plan.trajectory.length),
          Exact(plan.trajectory.duration),
          Exact(plan.trajectory.turned)};
}

}  // namespace

std::string RunFig10(const Fig10Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  progress.Show("scan");
  slam::PosedCloud scan = source.Read(0);
  scan.cloud_laser = slam::WithinRange(scan.cloud_laser, options.scan.min_range, options.scan.max_range);
  const PlanStep step = PlanNextScan(std::span(&scan, 1), options.step);
  const slam::SurfaceModel model =
      slam::MakeSurfaceModel(slam::SurfacesInMap(scan, options.surfaces.extract), options.surfaces);
  const control::GroundObstacles obstacles =
      ObstaclesOf(model, step, FloorUnder(std::span(&scan, 1)), options);
  progress.Show("trajectories");
  const Drives drives = DrivesOf(step, obstacles, options);
  Table table{{"behaviour", "start_m_deg", "goal_m_deg", "line_m", "length_m", "duration_s", "turned_rad"},
              {}};
  std::vector<Image> panels;
  for (const Drive& drive : drives.shown) {
    panels.push_back(DrivePanel(drive, step, obstacles, options));
    table.rows.push_back(RowOf(drive));
  }
  const std::vector<LegendEntry> legend{{"trajectory", PlanColors::kCandidate},
                                        {"what would hit", kBlockedColor},
                                        {"objects", kBoxColor},
                                        {"robot", PlanColors::kRobot},
                                        {"next view", PlanColors::kView}};
  if (!panels.empty())
    WritePng(run.File("figures/fig_10.png"),
             WithLegend(Grid(panels, {.columns = 3}), legend, {.cap_height = 20.0}));
  run.WriteCsv("trajectories.csv", table);
  run.WriteJson("metrics.json", {{"outlines", obstacles.outlines.size()},
                                 {"views", step.plan.views.size()},
                                 {"controller", drives.counts[0]},
                                 {"turn_first", drives.counts[1]},
                                 {"turn_straight_turn", drives.counts[2]},
                                 {"none", drives.counts[3]}});
  FinishRun(run, "Fig. 10: trajectories around boxes", panels.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
