#include "experiments/render/overlay.h"

#include <algorithm>
#include <string>

#include "experiments/render/color_map.h"
#include "experiments/render/text.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

Eigen::Vector2d PixelOf(const ImagePoint& point) { return {point.u, point.v}; }

/// The visible part of a segment as a line of the picture; empty where all of it is behind the camera.
Polyline ProjectedSegment(const Projector& project, const Eigen::Vector3d& from_map,
                          const Eigen::Vector3d& to_map) {
  Eigen::Vector3d from = project.ToCamera(from_map);
  Eigen::Vector3d to = project.ToCamera(to_map);
  if (!from.allFinite() || !to.allFinite()) Fail("a line to be drawn over a view is not finite");
  const bool from_visible = project.InFront(from.z());
  const bool to_visible = project.InFront(to.z());
  if (!from_visible && !to_visible) return {};
  constexpr double kCut = 1.001 * kNearestDepth;  // just in front, whatever the rounding
  const auto cut = [](const Eigen::Vector3d& hidden, const Eigen::Vector3d& visible) -> Eigen::Vector3d {
    return hidden + (visible - hidden) * std::min(1.0, (kCut - hidden.z()) / (visible.z() - hidden.z()));
  };
  if (!from_visible) from = cut(from, to);
  if (!to_visible) to = cut(to, from);
  return {PixelOf(project.FromCamera(from)), PixelOf(project.FromCamera(to))};
}

/// Two corners of a box joined by an edge differ in one bit: x (1), y (2) or z (4).
Eigen::Vector3d Corner(const Eigen::AlignedBox3d& box, int bits) {
  return {(bits & 1) ? box.max().x() : box.min().x(), (bits & 2) ? box.max().y() : box.min().y(),
          (bits & 4) ? box.max().z() : box.min().z()};
}

/// The triangle on the rim of a disc that points along `direction` (unit).
Polyline Pointer(const Eigen::Vector2d& center, const Eigen::Vector2d& direction, double radius) {
  const Eigen::Vector2d across(-direction.y(), direction.x());
  const Eigen::Vector2d base = center + 0.75 * radius * direction;
  return {base + 0.62 * radius * across, center + 1.75 * radius * direction, base - 0.62 * radius * across};
}

void DrawMark(Image& canvas, const Eigen::Vector2d& center, const Eigen::Vector2d& ahead, double radius,
              Rgb color, const std::string& label) {
  const double rim = 0.14 * radius;
  const bool has_direction = ahead.norm() > 1e-6;
  if (has_direction) {
    const Polyline pointer = Pointer(center, ahead.normalized(), radius);
    DrawPolylines(canvas, {{pointer[0], pointer[1], pointer[2]}}, {.color = kWhite, .width = 2.0 * rim});
    FillConvexPolygon(canvas, pointer, color);
  }
  FillCircle(canvas, center, radius + rim, kWhite);
  FillCircle(canvas, center, radius, color);
  if (label.empty()) return;
  TextStyle text{.color = kWhite, .cap_height = 1.05 * radius, .weight = 0.17};
  text.cap_height *= std::min(1.0, 1.55 * radius / TextWidth(label, text));
  DrawText(canvas, center + Eigen::Vector2d(0.0, 0.5 * text.cap_height), label, text, Align::kCenter);
}

}  // namespace

void DrawPath(Image& canvas, const Camera& camera, const std::vector<Eigen::Vector3d>& path_map,
              const Stroke& stroke) {
  const Projector project(camera);
  std::vector<Polyline> lines;
  for (std::size_t i = 0; i + 1 < path_map.size(); ++i) {
    Polyline line = ProjectedSegment(project, path_map[i], path_map[i + 1]);
    if (!line.empty()) lines.push_back(std::move(line));
  }
  DrawPolylines(canvas, lines, stroke);
}

void DrawBox(Image& canvas, const Camera& camera, const Eigen::AlignedBox3d& box_map,
             const Stroke& stroke) {
  const Projector project(camera);
  std::vector<Polyline> edges;
  for (int bits = 0; bits < 8; ++bits) {
    for (const int axis : {1, 2, 4}) {
      if (bits & axis) continue;
      Polyline edge = ProjectedSegment(project, Corner(box_map, bits), Corner(box_map, bits | axis));
      if (!edge.empty()) edges.push_back(std::move(edge));
    }
  }
  DrawPolylines(canvas, edges, stroke);
}

void DrawPoses(Image& canvas, const Camera& camera, const std::vector<slam::Pose3>& T_map_laser,
               const PoseStyle& style) {
  const Projector project(camera);
  const double radius = style.radius > 0.0 ? style.radius : std::max(8.0, 0.012 * canvas.width);
  for (std::size_t i = 0; i < T_map_laser.size(); ++i) {
    const slam::Pose3& pose = T_map_laser[i];
    if (!slam::IsFinite(pose)) Fail("pose {} to be drawn over a view is not finite", i);
    const ImagePoint origin = project(pose.translation);
    if (!project.InFront(origin.depth)) continue;
    // The direction in the picture, from a step so short that perspective does not bend it.
    const Eigen::Vector3d step = 1e-3 * pose.RotationMatrix().col(0);
    const Eigen::Vector2d ahead = 1e3 * (PixelOf(project(pose.translation + step)) - PixelOf(origin)) /
                                  project.PixelsPerMetre(origin.depth);
    DrawMark(canvas, PixelOf(origin), ahead, radius,
             style.colored_by_index ? CategoricalColor(i) : style.color,
             style.show_numbers ? std::to_string(style.first_number + static_cast<int>(i)) : "");
  }
}

}  // namespace ariadne::experiments
