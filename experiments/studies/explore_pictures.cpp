#include "experiments/studies/explore_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/render/glyphs.h"
#include "experiments/report/plan_picture.h"
#include "slam/geometry/triangulate.h"
#include "slam/io/svg.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kDashLength = 0.22, kDashGap = 0.14;      // of unseen edges [m]
constexpr double kPlannedDash = 0.10, kPlannedGap = 0.10;  // of planned ways [m]
constexpr Rgb kObstacleInk{206, 170, 110};
constexpr Rgb kDrivenInk{20, 128, 84};
const slam::SvgOptions kStepSvg{.line_width = 0.4, .point_size = 0.5};

Eigen::Vector3d OnPaper(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

slam::DrawingLayer StepLayer(const std::string& name, Rgb color) { return {name, color, {}, {}, {}}; }

slam::DrawingLayer AreaLayer(std::span<const planning::LabelledPolygon> area) {
  slam::DrawingLayer layer = StepLayer("free", PlanColors::kFree);
  std::vector<slam::Polygon2> plain;
  for (const planning::LabelledPolygon& polygon : area) plain.push_back(planning::ToPolygon2(polygon));
  const slam::Triangles2 cut = slam::Triangulated(plain);
  for (const Eigen::Vector2d& p : cut.vertices) layer.mesh.vertices.push_back(OnPaper(p));
  layer.mesh.triangles.assign(cut.triangles.begin(), cut.triangles.end());
  return layer;
}

/// Cells of a raster in rows; those beside each other as a line, which takes less room in files.
slam::DrawingLayer ObstacleLayer(std::vector<Eigen::Vector2d> places) {
  constexpr double kSameRow = 1e-6, kBeside = 0.06;  // the raster is finer [m]
  std::ranges::sort(places, [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
  });
  slam::DrawingLayer layer = StepLayer("obstacles", kObstacleInk);
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    for (end = begin + 1; end < places.size(); ++end) {
      const Eigen::Vector2d gap = places[end] - places[end - 1];
      if (std::abs(gap.y()) > kSameRow || gap.x() > kBeside) break;
    }
    if (end == begin + 1) {
      layer.points.push_back(OnPaper(places[begin]));
    } else {
      layer.lines.push_back({{OnPaper(places[begin]), OnPaper(places[end - 1])}, false});
    }
  }
  return layer;
}

slam::DrawingLayer DashedLayer(const std::string& name, Rgb color, std::span<const Segment> lines,
                               double dash, double gap) {
  std::vector<Segment> dashes;
  for (const Segment& line : lines) std::ranges::move(Dashed(line, dash, gap), std::back_inserter(dashes));
  return LayerOf(name, color, dashes);
}

/// In letters of a height [m], centred on the place or to the right of it.
void WriteOn(slam::DrawingLayer& layer, const Eigen::Vector2d& place, std::string_view text, double height,
             bool centred) {
  const double unit = height / kCapUnits;
  double width = -kLetterGapUnits;
  for (const char c : text) width += GlyphOf(static_cast<unsigned char>(c)).width + kLetterGapUnits;
  double x = place.x() - (centred ? 0.5 * width * unit : 0.0);
  for (const char c : text) {
    const Glyph glyph = GlyphOf(static_cast<unsigned char>(c));
    for (const Polyline& stroke : glyph.strokes) {
      slam::Polyline3 line;
      for (const Eigen::Vector2d& p : stroke)
        line.points.push_back({x + unit * p.x(), place.y() - 0.5 * height + unit * p.y(), 0.0});
      layer.lines.push_back(std::move(line));
    }
    x += (glyph.width + kLetterGapUnits) * unit;
  }
}

slam::Polyline3 Ring(const Eigen::Vector2d& center, double radius) {
  constexpr int kCorners = 24;
  slam::Polyline3 ring{{}, true};
  for (int i = 0; i < kCorners; ++i) {
    const double at = 2.0 * std::numbers::pi * i / kCorners;
    ring.points.push_back(OnPaper(center + radius * Eigen::Vector2d(std::cos(at), std::sin(at))));
  }
  return ring;
}

/// The robot's outline with an arrow to where it looks, on a pale ground in a layer of its own.
void DrawRobotAt(slam::Drawing& drawing, const std::string& name, const std::optional<Pose2>& at_map,
                 Rgb color) {
  constexpr double kHalfLength = 0.4, kHalfWidth = 0.3;  // Sec. 2.1 [m]
  slam::DrawingLayer ground = StepLayer(name + "_ground", Mix(color, kWhite, 0.75));
  slam::DrawingLayer layer = StepLayer(name, color);
  if (at_map) {
    const auto at = [&at_map](double x, double y) { return OnPaper(*at_map * Eigen::Vector2d(x, y)); };
    ground.mesh.vertices = {at(kHalfLength, kHalfWidth), at(-kHalfLength, kHalfWidth),
                            at(-kHalfLength, -kHalfWidth), at(kHalfLength, -kHalfWidth)};
    ground.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    layer.lines.push_back({ground.mesh.vertices, true});
    layer.lines.push_back({{at(-0.15, 0.15), at(0.25, 0.0), at(-0.15, -0.15)}, false});
  }
  drawing.layers.push_back(std::move(ground));
  drawing.layers.push_back(std::move(layer));
}

/// Without those that a later one stands over, so that numbers can be read.
std::vector<std::size_t> ShownStops(const std::vector<Pose2>& T_map_stops) {
  constexpr double kNear = 0.45;  // [m]
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i + 1 < T_map_stops.size(); ++i) {
    const Eigen::Vector2d& place = T_map_stops[i].translation;
    const auto later = T_map_stops.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const bool hidden = std::any_of(later, T_map_stops.end(), [&place](const Pose2& pose) {
      return (pose.translation - place).norm() < kNear;
    });
    if (!hidden) shown.push_back(i);
  }
  return shown;
}

/// Numbers in rings, on a white ground.
void DrawStops(slam::Drawing& drawing, const std::vector<Pose2>& T_map_stops) {
  constexpr double kRing = 0.28, kHeight = 0.24;  // [m]
  slam::DrawingLayer ground = StepLayer("stops_ground", kWhite), layer = StepLayer("stops", kDrivenInk);
  for (const std::size_t i : ShownStops(T_map_stops)) {
    const Eigen::Vector2d& place = T_map_stops[i].translation;
    const slam::Polyline3 ring = Ring(place, kRing);
    const auto first = static_cast<std::uint32_t>(ground.mesh.vertices.size());
    ground.mesh.vertices.insert(ground.mesh.vertices.end(), ring.points.begin(), ring.points.end());
    for (std::uint32_t k = 1; k + 1 < ring.points.size(); ++k)
      ground.mesh.triangles.push_back({first, first + k, first + k + 1});
    layer.lines.push_back(ring);
    WriteOn(layer, place, std::to_string(i), kHeight, true);
  }
  drawing.layers.push_back(std::move(ground));
  drawing.layers.push_back(std::move(layer));
}

std::optional<Pose2> ViewPose(const ExploredStep& step) {
  if (!step.view) return {};
  return Pose2{step.view->direction, step.view->p_map};
}

std::string CaptionOf(const ExploredStep& step) {
  if (!step.registered) return fmt::format("after scan {}, which could not be registered", step.index);
  if (step.planned_map.empty()) return fmt::format("after scan {}", step.index);
  if (!step.view) return fmt::format("after scan {}: back to where it was sure", step.index);
  return fmt::format("after scan {}: next view for {} rays, {:.1f} m away", step.index, step.view->gain,
                     step.view->distance);
}

struct StepLegendEntry {
  std::string layer, text;
};

const std::vector<StepLegendEntry>& StepLegend() {
  static const std::vector<StepLegendEntry> kEntries{
      {"seen", "seen: walls, furniture"}, {"unseen", "nobody has looked behind"},
      {"obstacles", "in the way"},        {"driven", "driven, with stops"},
      {"planned", "planned way"},         {"next_view", "next view"}};
  return kEntries;
}

/// What a layer's lines look like, added to it.
void AppendSample(slam::DrawingLayer& layer, const Eigen::Vector2d& place, double length) {
  const Segment sample(place, place + Eigen::Vector2d(length, 0.0));
  if (layer.name == "obstacles") {
    for (int i = 0; i <= 10; ++i)
      layer.points.push_back(OnPaper(place + Eigen::Vector2d(0.1 * i * length, 0.0)));
    return;
  }
  std::vector<Segment> pieces{sample};
  if (layer.name == "unseen") pieces = Dashed(sample, kDashLength, kDashGap);
  if (layer.name == "planned") pieces = Dashed(sample, kPlannedDash, kPlannedGap);
  for (const auto& [from, to] : pieces) layer.lines.push_back({{OnPaper(from), OnPaper(to)}, false});
}

/// A caption, and samples of all lines in columns, below the drawing.
void AppendLegend(slam::Drawing& drawing, const ExploredStep& step) {
  constexpr double kHeight = 0.3, kPitch = 0.6, kSample = 1.0, kColumn = 8.0;  // [m]
  Eigen::Vector2d low = step.T_map_base().translation, high = low;
  for (const Eigen::Vector2d& corner : CornersOf(step.area)) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  slam::DrawingLayer ink = StepLayer("legend", {24, 30, 40});
  const Eigen::Vector2d begin = low - Eigen::Vector2d(0.0, 2.0 * kPitch);
  WriteOn(ink, begin, CaptionOf(step), 1.2 * kHeight, false);
  const int columns = std::clamp(static_cast<int>((high.x() - low.x()) / kColumn), 1, 3);
  int count = 0;
  for (const auto& [name, text] : StepLegend()) {
    const auto layer = std::ranges::find(drawing.layers, name, &slam::DrawingLayer::name);
    if (layer->lines.empty() && layer->points.empty()) continue;
    const int column = count % columns, row = 1 + count / columns;
    const Eigen::Vector2d place = begin + Eigen::Vector2d(kColumn * column, -kPitch * row);
    AppendSample(*layer, place, kSample);
    WriteOn(ink, place + Eigen::Vector2d(1.3 * kSample, 0.0), text, kHeight, false);
    ++count;
  }
  drawing.layers.push_back(std::move(ink));
}

slam::DrawingLayer LineLayer(const std::string& name, Rgb color, std::span<const Eigen::Vector2d> places) {
  slam::DrawingLayer layer = StepLayer(name, color);
  slam::Polyline3 line;
  for (const Eigen::Vector2d& p : places) line.points.push_back(OnPaper(p));
  if (line.points.size() > 1) layer.lines.push_back(std::move(line));
  return layer;
}

/// Dashes along a way whose pieces are shorter than a dash.
slam::DrawingLayer PlannedLayer(const std::vector<Pose2>& planned_map) {
  slam::DrawingLayer layer = StepLayer("planned", PlanColors::kView);
  double way = 0.0;
  for (std::size_t i = 1; i < planned_map.size(); ++i) {
    const Eigen::Vector2d &from = planned_map[i - 1].translation, &to = planned_map[i].translation;
    if (std::fmod(way, kPlannedDash + kPlannedGap) < kPlannedDash && from != to)
      layer.lines.push_back({{OnPaper(from), OnPaper(to)}, false});
    way += (to - from).norm();
  }
  return layer;
}

}  // namespace

slam::Drawing DrawingOf(const ExploredStep& step, std::span<const Eigen::Vector2d> driven_map) {
  slam::Drawing drawing;
  drawing.layers.push_back(AreaLayer(step.area));
  drawing.layers.push_back(ObstacleLayer(step.obstacles_map));
  drawing.layers.push_back(
      DashedLayer("unseen", PlanColors::kUnseen, SegmentsOf(step.area, false), kDashLength, kDashGap));
  drawing.layers.push_back(LayerOf("seen", PlanColors::kSeen, SegmentsOf(step.area, true)));
  drawing.layers.push_back(LineLayer("driven", kDrivenInk, driven_map));
  drawing.layers.push_back(PlannedLayer(step.planned_map));
  DrawStops(drawing, step.T_map_stops);
  DrawRobotAt(drawing, "robot", step.T_map_base(), PlanColors::kRobot);
  DrawRobotAt(drawing, "next_view", ViewPose(step), PlanColors::kView);
  AppendLegend(drawing, step);
  return drawing;
}

std::string StepsHtml(std::size_t count) {
  if (count == 0) return "";
  return fmt::format(
      "<h2>Step by step</h2>\n"
      "<p><label>Scan <output id=\"step-number\">{0}</output><br>\n"
      "<input id=\"step-slider\" type=\"range\" min=\"0\" max=\"{0}\" value=\"{0}\" "
      "style=\"width:100%\"></label></p>\n"
      "<a id=\"step-link\" href=\"{1}.svg\"><img id=\"step-picture\" src=\"{1}.svg\" alt=\"what was known "
      "and planned after this scan\" "
      "style=\"width:100%;max-height:42rem;object-fit:contain;background:#fff\"></a>\n"
      "<script>document.getElementById('step-slider').addEventListener('input', event => {{\n"
      "  const file = 'steps/step' + event.target.value.padStart(3, '0') + '.svg';\n"
      "  document.getElementById('step-number').value = event.target.value;\n"
      "  document.getElementById('step-picture').src = file;\n"
      "  document.getElementById('step-link').href = file;\n"
      "}});</script>\n",
      count - 1, StepName(count - 1));
}

void StepKeeper::Write(const ExploredStep& step) const {
  run_.WriteJson(StepName(step.index) + ".json", ToJson(step));
  slam::WriteSvg(run_.File(StepName(step.index) + ".svg"), DrawingOf(step, steps_.driven_map()), kStepSvg);
}

}  // namespace ariadne::experiments
