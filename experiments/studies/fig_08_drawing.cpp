#include "experiments/studies/fig_08_drawing.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/fit_camera.h"

namespace ariadne::experiments {
namespace {

constexpr double kPenShare = 0.0018;    // of the picture's width
constexpr double kHeadLength = 7.0;     // [pens]
constexpr double kDashLength = 6.0;     // [pens]
constexpr double kLetterHeight = 11.0;  // [pens]
constexpr Rgb kTire{52, 56, 64};

Camera CameraOnFrames(const Polyline& places, int width) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& p : places) points.emplace_back(p.x(), p.y(), 0.0);
  return Fitted(TopView({width, width}), points,
                {.outlier_share = 0.0, .margin = width / 24, .adjust_height = true});
}

Eigen::Vector2d UnitAt(double direction) { return {std::cos(direction), std::sin(direction)}; }

Polyline RectangleAbout(const slam::Pose2& pose, const Eigen::Vector2d& center, double length,
                        double width) {
  Polyline corners;
  for (const auto& [x, y] : {std::pair(0.5, 0.5), {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}})
    corners.push_back(pose * Eigen::Vector2d(center + Eigen::Vector2d(x * length, y * width)));
  return corners;
}

}  // namespace

FrameCanvas::FrameCanvas(const Polyline& places, int width)
    : camera_(CameraOnFrames(places, width)),
      pen_(std::max(1.0, kPenShare * width)),
      image_(camera_.width, camera_.height) {}

Eigen::Vector2d FrameCanvas::InPicture(const Eigen::Vector2d& place) const {
  const ImagePoint point = Projector(camera_)(Eigen::Vector3d(place.x(), place.y(), 0.0));
  return {point.u, point.v};
}

void FrameCanvas::Line(const Polyline& places, Rgb color, double pen) {
  Polyline line;
  for (const Eigen::Vector2d& p : places) line.push_back(InPicture(p));
  DrawPolylines(image_, {line}, {.color = color, .width = pen * pen_});
}

void FrameCanvas::DashedLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb color,
                             double pen) {
  const Eigen::Vector2d begin = InPicture(from), run = InPicture(to) - begin;
  const int dashes = std::max(1, static_cast<int>(run.norm() / (2.0 * kDashLength * pen_)));
  std::vector<Polyline> lines;
  for (int i = 0; i < dashes; ++i) {
    const double at = 2.0 * i / (2.0 * dashes - 1.0), end = (2.0 * i + 1.0) / (2.0 * dashes - 1.0);
    lines.push_back({begin + at * run, begin + end * run});
  }
  DrawPolylines(image_, lines, {.color = color, .width = pen * pen_});
}

void FrameCanvas::Fill(const Polyline& convex, Rgb color) {
  Polyline corners;
  for (const Eigen::Vector2d& p : convex) corners.push_back(InPicture(p));
  FillConvexPolygon(image_, corners, color);
}

void FrameCanvas::Head(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, Rgb color, double pen) {
  const double length = kHeadLength * (0.5 + 0.5 * pen) * pen_ / camera_.scale;
  const Eigen::Vector2d ahead = along.normalized(), across(-ahead.y(), ahead.x());
  const Eigen::Vector2d base = tip - length * ahead;
  Fill({tip, base + 0.38 * length * across, base - 0.38 * length * across}, color);
}

void FrameCanvas::Arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb color, double pen) {
  const Eigen::Vector2d along = to - from;
  const double head = 0.8 * kHeadLength * (0.5 + 0.5 * pen) * pen_ / camera_.scale;
  Line({from, to - head * along.normalized()}, color, pen);
  Head(to, along, color, pen);
}

void FrameCanvas::Arc(const Eigen::Vector2d& center, double radius, double from, double to, Rgb color,
                      double pen) {
  constexpr int kPieces = 64;
  const double sense = to < from ? -1.0 : 1.0;
  const double head = 0.8 * kHeadLength * (0.5 + 0.5 * pen) * pen_ / camera_.scale / radius;
  const double last = std::abs(to - from) > head ? to - sense * head : from;
  Polyline arc;
  for (int i = 0; i <= kPieces; ++i)
    arc.push_back(center + radius * UnitAt(from + (last - from) * i / kPieces));
  Line(arc, color, pen);
  // The chord from where the head begins is its direction.
  const Eigen::Vector2d tip = center + radius * UnitAt(to);
  Head(tip, tip - (center + radius * UnitAt(to - sense * head)), color, pen);
}

void FrameCanvas::Dot(const Eigen::Vector2d& place, Rgb color, double pen) {
  FillCircle(image_, InPicture(place), 2.0 * pen * pen_, color);
}

void FrameCanvas::Robot(const slam::Pose2& pose, double length, double width, double track, Rgb color) {
  constexpr double kWheelLength = 0.2, kWheelWidth = 0.05, kCastor = 0.035;  // [m]
  Polyline outline = RectangleAbout(pose, Eigen::Vector2d::Zero(), length, width);
  Fill(outline, Mix(color, kWhite, 0.82));
  outline.push_back(outline.front());
  Line(outline, color, 1.2);
  for (const double side : {-0.5, 0.5}) {
    Fill(RectangleAbout(pose, {0.0, side * track}, kWheelLength, kWheelWidth), kTire);
    for (const double end : {-0.5, 0.5}) {
      const Eigen::Vector2d castor(end * (length - 0.16), side * (width - 0.14));
      FillCircle(image_, InPicture(pose * castor), kCastor * camera_.scale, Mix(kTire, kWhite, 0.35));
    }
  }
}

void FrameCanvas::Text(const Eigen::Vector2d& place, std::string_view text, Rgb color, double size) {
  const TextStyle style{
      .color = color, .cap_height = size * kLetterHeight * pen_, .halo_width = 1.5 * pen_};
  const Eigen::Vector2d down(0.0, 0.5 * style.cap_height);
  DrawText(image_, InPicture(place) + down, text, style, Align::kCenter);
}

}  // namespace ariadne::experiments
