#include "experiments/report/plan_picture.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/fit_camera.h"
#include "experiments/render/scales.h"
#include "slam/geometry/triangulate.h"

namespace ariadne::experiments {
namespace {

constexpr double kDash = 11.0;       // [px]
constexpr double kGap = 8.0;         // between dashes [px]
constexpr double kRobotSize = 16.0;  // of its mark [px]

Camera CameraOver(std::span<const Eigen::Vector2d> places_map, int width) {
  std::vector<Eigen::Vector3d> places;
  for (const Eigen::Vector2d& p : places_map) places.emplace_back(p.x(), p.y(), 0.0);
  Camera camera = TopView({width, width});
  return Fitted(camera, places, {.outlier_share = 0.0, .margin = 48, .adjust_height = true});
}

Eigen::Vector3d Flat(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

}  // namespace

PlanCanvas::PlanCanvas(std::span<const Eigen::Vector2d> places_map, int width)
    : camera_(CameraOver(places_map, width)), project_(camera_), image_(camera_.width, camera_.height) {}

Eigen::Vector2d PlanCanvas::InPicture(const Eigen::Vector2d& p_map) const {
  const ImagePoint point = project_(Flat(p_map));
  return {point.u, point.v};
}

void PlanCanvas::Area(std::span<const planning::LabelledPolygon> area) {
  std::vector<slam::Polygon2> plain;
  for (const planning::LabelledPolygon& polygon : area) plain.push_back(planning::ToPolygon2(polygon));
  const slam::Triangles2 cut = slam::Triangulated(plain);
  std::vector<Polyline> seams;
  for (const auto& triangle : cut.triangles) {
    Polyline corners;
    for (const std::uint32_t i : triangle) corners.push_back(InPicture(cut.vertices[i]));
    FillConvexPolygon(image_, corners, PlanColors::kFree);
    corners.push_back(corners.front());
    seams.push_back(std::move(corners));
  }
  DrawPolylines(image_, seams, {.color = PlanColors::kFree, .width = 1.0});
}

void PlanCanvas::Edges(std::span<const planning::LabelledPolygon> area, double width) {
  Dashes(SegmentsOf(area, false), {.color = PlanColors::kUnseen, .width = width});
  Lines(SegmentsOf(area, true), {.color = PlanColors::kSeen, .width = width});
}

void PlanCanvas::Points(std::span<const Eigen::Vector2d> points_map, Rgb color, double radius) {
  for (const Eigen::Vector2d& p : points_map) FillCircle(image_, InPicture(p), radius, color);
}

void PlanCanvas::Lines(std::span<const Segment> lines_map, const Stroke& stroke) {
  std::vector<Polyline> lines;
  for (const auto& [from, to] : lines_map) lines.push_back({InPicture(from), InPicture(to)});
  DrawPolylines(image_, lines, stroke);
}

void PlanCanvas::Dashes(std::span<const Segment> lines_map, const Stroke& stroke) {
  std::vector<Segment> dashes;
  for (const Segment& line : lines_map) {
    std::ranges::move(Dashed(line, kDash / camera_.scale, kGap / camera_.scale),
                      std::back_inserter(dashes));
  }
  Lines(dashes, stroke);
}

void PlanCanvas::Robot(const slam::Pose2& T_map_robot, Rgb color) {
  const double size = kRobotSize / camera_.scale;
  const auto at = [&](double x, double y) {
    return InPicture(T_map_robot * Eigen::Vector2d(size * x, size * y));
  };
  for (const double side : {-1.0, 1.0}) {
    FillConvexPolygon(image_, {at(1.2, 0.0), at(-0.8, 0.8 * side), at(-0.4, 0.0)}, color);
  }
}

void PlanCanvas::Text(const Eigen::Vector2d& p_map, std::string_view text, Rgb color,
                      const Eigen::Vector2d& shift) {
  TextStyle style = AnnotationText(image_, {});
  style.color = color;
  style.halo_width = 4.0;
  const Eigen::Vector2d down(0.0, 0.5 * style.cap_height);
  DrawText(image_, InPicture(p_map) + shift + down, text, style, Align::kCenter);
}

Image PlanCanvas::Finished(std::string_view title) const {
  return WithScaleBar(WithTitle(image_, title), camera_);
}

std::vector<Eigen::Vector2d> CornersOf(std::span<const planning::LabelledPolygon> area) {
  std::vector<Eigen::Vector2d> corners;
  for (const planning::LabelledPolygon& polygon : area) {
    for (const planning::LabelledCorner& corner : polygon.outer) corners.push_back(corner.p_map);
  }
  return corners;
}

std::vector<Segment> SegmentsOf(std::span<const planning::LabelledPolygon> area, bool seen) {
  std::vector<Segment> segments;
  const auto append = [&](const planning::LabelledRing& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring[i].seen == seen) segments.emplace_back(ring[i].p_map, ring[(i + 1) % ring.size()].p_map);
    }
  };
  for (const planning::LabelledPolygon& polygon : area) {
    append(polygon.outer);
    for (const planning::LabelledRing& hole : polygon.holes) append(hole);
  }
  return segments;
}

std::vector<Segment> Dashed(const Segment& line, double dash, double gap) {
  const double length = (line.second - line.first).norm();
  // As many whole dashes as come closest, so that each line begins and ends with one.
  const double count = std::max(1.0, std::round((length + gap) / (dash + gap)));
  const double period = (length + gap) / count;
  std::vector<Segment> dashes;
  for (double i = 0.0; i < count; ++i) {
    const double begin = i * period / length;
    const double end = std::min(1.0, begin + std::max(period - gap, 0.5 * period) / length);
    const Eigen::Vector2d run = line.second - line.first;
    dashes.emplace_back(line.first + begin * run, line.first + end * run);
  }
  return dashes;
}

ViewRays RaysOf(const planning::View& view, std::span<const planning::LabelledPolygon> area,
                const slam::Pose2& T_map_robot, const planning::RayGainOptions& options) {
  const std::vector<planning::Edge> edges = planning::EdgesOf(area);
  const planning::RayGain gain(edges, T_map_robot.angle, options);
  const std::vector<planning::RayHit> hits = gain.Cast(view.p_map);
  ViewRays rays;
  for (const std::size_t i : gain.RaysAbout(view.direction)) {
    const double range = std::min(hits[i].distance, options.max_range);
    (gain.IsUnseen(hits[i]) ? rays.unseen : rays.other)
        .emplace_back(view.p_map, view.p_map + range * gain.Direction(i));
  }
  return rays;
}

slam::DrawingLayer LayerOf(const std::string& name, Rgb color, std::span<const Segment> lines_map) {
  slam::DrawingLayer layer{name, color, {}, {}, {}};
  for (const auto& [from, to] : lines_map) layer.lines.push_back({{Flat(from), Flat(to)}, false});
  return layer;
}

slam::DrawingLayer LayerOf(const std::string& name, Rgb color,
                           std::span<const Eigen::Vector2d> points_map) {
  slam::DrawingLayer layer{name, color, {}, {}, {}};
  for (const Eigen::Vector2d& p : points_map) layer.points.push_back(Flat(p));
  return layer;
}

}  // namespace ariadne::experiments
