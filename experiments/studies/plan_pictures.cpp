#include "experiments/studies/plan_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/studies/plan_sorting.h"

namespace ariadne::experiments {
namespace {

constexpr Rgb kPaleRay{226, 214, 232};
constexpr Rgb kGainRay{204, 164, 214};

std::vector<Eigen::Vector2d> PlacesOf(const PlanStep& step) {
  std::vector<Eigen::Vector2d> places = CornersOf(step.area);
  places.push_back(step.T_map_robot.translation);
  return places;
}

std::vector<Eigen::Vector2d> CandidatesOf(const PlanStep& step) {
  std::vector<Eigen::Vector2d> places;
  for (const planning::View& view : step.plan.views) places.push_back(view.p_map);
  return places;
}

std::vector<Segment> WayOf(const PlanStep& step) {
  std::vector<Segment> way;
  for (std::size_t i = 0; i + 1 < step.plan.path_map.size(); ++i) {
    way.emplace_back(step.plan.path_map[i], step.plan.path_map[i + 1]);
  }
  return way;
}

std::vector<Segment> LinesInMap(const PlanStep& step, std::size_t scan) {
  const slam::Pose2& T_map_scan = step.slices[scan].T_map_scan;
  std::vector<Segment> lines;
  for (const planning::SliceLine& line : step.lines[scan]) {
    lines.emplace_back(T_map_scan * line.from_scan, T_map_scan * line.to_scan);
  }
  return lines;
}

/// Marks of candidates, which points as fine as those of walls would be lost among.
std::vector<Segment> Crosses(const std::vector<Eigen::Vector2d>& places_map) {
  constexpr double kHalf = 0.04;  // [m]
  std::vector<Segment> crosses;
  for (const Eigen::Vector2d& p : places_map) {
    for (const Eigen::Vector2d& arm : {Eigen::Vector2d(kHalf, kHalf), Eigen::Vector2d(kHalf, -kHalf)}) {
      crosses.emplace_back(p - arm, p + arm);
    }
  }
  return crosses;
}

std::vector<Segment> Arrow(const slam::Pose2& T_map_robot) {
  constexpr double kSize = 0.25;  // [m]
  const std::vector<Eigen::Vector2d> corners{{1.2, 0.0}, {-0.8, 0.8}, {-0.4, 0.0}, {-0.8, -0.8}};
  std::vector<Segment> arrow;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    arrow.emplace_back(T_map_robot * Eigen::Vector2d(kSize * corners[i]),
                       T_map_robot * Eigen::Vector2d(kSize * corners[(i + 1) % corners.size()]));
  }
  return arrow;
}

void DrawView(PlanCanvas& canvas, const PlanStep& step, const PlanStepOptions& options) {
  if (!step.plan.chosen) return;
  const planning::View& view = step.plan.views[*step.plan.chosen];
  const ViewRays rays = RaysOf(view, step.area, step.T_map_robot, options.planner.view.gain);
  canvas.Lines(rays.other, {.color = kPaleRay, .width = 1.0});
  canvas.Lines(rays.unseen, {.color = PlanColors::kView, .width = 1.0, .opacity = 0.6});
}

void DrawPoses(PlanCanvas& canvas, const PlanStep& step) {
  if (step.plan.chosen) {
    const planning::View& view = step.plan.views[*step.plan.chosen];
    canvas.Lines(WayOf(step), {.color = PlanColors::kRobot, .width = 2.5});
    canvas.Robot({view.direction, view.p_map}, PlanColors::kView);
  }
  canvas.Robot(step.T_map_robot, PlanColors::kRobot);
}

}  // namespace

Image PlanPicture(const PlanStep& step, const PlanStepOptions& options, int width, std::string_view title) {
  PlanCanvas canvas(PlacesOf(step), width);
  canvas.Area(step.area);
  DrawView(canvas, step, options);
  canvas.Points(CandidatesOf(step), PlanColors::kCandidate, 2.5);
  canvas.Edges(step.area);
  DrawPoses(canvas, step);
  return canvas.Finished(title);
}

std::vector<Image> PlanningPanels(const PlanStep& step, const PlanStepOptions& options, int width) {
  const std::size_t last = step.slices.size() - 1;
  const PlanCanvas empty(PlacesOf(step), width);
  PlanCanvas points = empty, lines = empty, polygon = empty, candidates = empty, chosen = empty;
  points.Points(step.slices[last].points_map, PlanColors::kPoint, 2.2);
  lines.Lines(LinesInMap(step, last), {.color = PlanColors::kSeen, .width = 3.0});
  for (PlanCanvas* canvas : {&polygon, &candidates, &chosen}) canvas->Area(step.area);
  polygon.Edges(step.area);
  candidates.Edges(step.area, 2.0);
  candidates.Points(CandidatesOf(step), PlanColors::kCandidate, 4.0);
  DrawView(chosen, step, options);
  chosen.Edges(step.area);
  DrawPoses(chosen, step);
  for (PlanCanvas* canvas : {&points, &lines, &polygon, &candidates}) {
    canvas->Robot(step.T_map_robot, PlanColors::kRobot);
  }
  return {
      points.Finished(fmt::format("(a) {} points", step.slices[last].points_map.size())),
      lines.Finished("(b) Lines"),
      polygon.Finished("(c) Polygon"),
      SortingPicture(step.polygons[last], step.slices[last].T_map_scan, width, "(d) Order of the lines"),
      candidates.Finished(fmt::format("(e) {} candidates", step.plan.views.size())),
      chosen.Finished("(f) Next view")};
}

slam::Drawing DrawingOf(const PlanStep& step, const PlanStepOptions& options) {
  constexpr double kDash = 0.2, kGap = 0.12;  // [m]
  slam::Drawing drawing;
  std::vector<Eigen::Vector2d> points;
  for (const slam::HorizontalSlice& slice : step.slices) {
    points.insert(points.end(), slice.points_map.begin(), slice.points_map.end());
  }
  std::vector<Segment> dashes;
  for (const Segment& edge : SegmentsOf(step.area, false)) {
    std::ranges::move(Dashed(edge, kDash, kGap), std::back_inserter(dashes));
  }
  if (step.plan.chosen) {
    const planning::View& view = step.plan.views[*step.plan.chosen];
    const ViewRays rays = RaysOf(view, step.area, step.T_map_robot, options.planner.view.gain);
    drawing.layers.push_back(LayerOf("rays", kPaleRay, rays.other));
    drawing.layers.push_back(LayerOf("gain", kGainRay, rays.unseen));
  }
  drawing.layers.push_back(LayerOf("points", PlanColors::kPoint, points));
  drawing.layers.push_back(LayerOf("candidates", PlanColors::kCandidate, Crosses(CandidatesOf(step))));
  drawing.layers.push_back(LayerOf("unseen", PlanColors::kUnseen, dashes));
  drawing.layers.push_back(LayerOf("seen", PlanColors::kSeen, SegmentsOf(step.area, true)));
  drawing.layers.push_back(LayerOf("way", PlanColors::kRobot, WayOf(step)));
  drawing.layers.push_back(LayerOf("robot", PlanColors::kRobot, Arrow(step.T_map_robot)));
  if (step.plan.chosen) {
    const planning::View& view = step.plan.views[*step.plan.chosen];
    drawing.layers.push_back(LayerOf("next_view", PlanColors::kView, Arrow({view.direction, view.p_map})));
  }
  return drawing;
}

std::vector<LegendEntry> PlanLegend() {
  return {{"seen", PlanColors::kSeen},
          {"unseen (dashed)", PlanColors::kUnseen},
          {"robot, way", PlanColors::kRobot},
          {"candidates", PlanColors::kCandidate},
          {"next view, gain", PlanColors::kView}};
}

}  // namespace ariadne::experiments
