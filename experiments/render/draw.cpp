#include "experiments/render/draw.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/mask.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

void RequireFinite(const Eigen::Vector2d& p) {
  if (!p.allFinite()) Fail("a point ({}, {}) to be drawn is not finite", p.x(), p.y());
}

/// The box around the points, wider by a rim on all sides. [px]
Eigen::AlignedBox2d BoundsOf(const Polyline& points, double rim) {
  Eigen::AlignedBox2d bounds;
  for (const Eigen::Vector2d& p : points) {
    RequireFinite(p);
    bounds.extend(p - Eigen::Vector2d::Constant(rim));
    bounds.extend(p + Eigen::Vector2d::Constant(rim));
  }
  return bounds;
}

void PaintLines(Image& canvas, const std::vector<Polyline>& lines, double width, Rgb color,
                double opacity) {
  Eigen::AlignedBox2d bounds;
  for (const Polyline& line : lines) bounds.extend(BoundsOf(line, 0.5 * width + 0.5));
  if (bounds.isEmpty()) return;
  Mask mask(canvas, bounds);
  for (const Polyline& line : lines) {
    if (line.size() == 1) mask.AddSegment(line[0], line[0], width);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) mask.AddSegment(line[i], line[i + 1], width);
  }
  mask.Paint(canvas, color, opacity);
}

template <typename SignedDistance>
void PaintShape(Image& canvas, const Eigen::AlignedBox2d& bounds, Rgb color, double opacity,
                const SignedDistance& signed_distance) {
  if (bounds.isEmpty()) return;
  Mask mask(canvas, bounds);
  mask.AddShape(bounds, signed_distance);
  mask.Paint(canvas, color, opacity);
}

/// Twice the area, positive where the corners run from x to y.
double SignedArea(const Polyline& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

}  // namespace

void DrawPolylines(Image& canvas, const std::vector<Polyline>& lines, const Stroke& stroke) {
  if (stroke.halo_width > 0.0) {
    PaintLines(canvas, lines, stroke.width + 2.0 * stroke.halo_width, stroke.halo, stroke.opacity);
  }
  PaintLines(canvas, lines, stroke.width, stroke.color, stroke.opacity);
}

void DrawLine(Image& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Stroke& stroke) {
  DrawPolylines(canvas, {{from, to}}, stroke);
}

void FillCircle(Image& canvas, const Eigen::Vector2d& center, double radius, Rgb color, double opacity) {
  PaintShape(canvas, BoundsOf({center}, radius + 0.5), color, opacity,
             [&](const Eigen::Vector2d& p) { return (p - center).norm() - radius; });
}

void DrawCircle(Image& canvas, const Eigen::Vector2d& center, double radius, const Stroke& stroke) {
  const auto ring = [&](double width, Rgb color) {
    PaintShape(
        canvas, BoundsOf({center}, radius + 0.5 * width + 0.5), color, stroke.opacity,
        [&](const Eigen::Vector2d& p) { return std::abs((p - center).norm() - radius) - 0.5 * width; });
  };
  if (stroke.halo_width > 0.0) ring(stroke.width + 2.0 * stroke.halo_width, stroke.halo);
  ring(stroke.width, stroke.color);
}

void FillConvexPolygon(Image& canvas, const Polyline& corners, Rgb color, double opacity) {
  const double sense = SignedArea(corners) < 0.0 ? -1.0 : 1.0;
  PaintShape(canvas, BoundsOf(corners, 0.5), color, opacity, [&](const Eigen::Vector2d& p) {
    double distance = -1e9;  // to the sides' lines, which is enough for a convex shape
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
      const Eigen::Vector2d outward = sense * Eigen::Vector2d(side.y(), -side.x()).normalized();
      distance = std::max(distance, outward.dot(p - corners[i]));
    }
    return distance;
  });
}

void FillRectangle(Image& canvas, const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite, Rgb color,
                   double opacity) {
  FillConvexPolygon(canvas, {corner, {opposite.x(), corner.y()}, opposite, {corner.x(), opposite.y()}},
                    color, opacity);
}

}  // namespace ariadne::experiments
