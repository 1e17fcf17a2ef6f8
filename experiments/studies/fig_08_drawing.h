#pragma once

#include <string_view>

#include "experiments/render/camera.h"
#include "experiments/render/draw.h"
#include "experiments/render/text.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

/// A drawing of frames, angles and lengths in the plane [m].
class FrameCanvas {
 public:
  /// Shows all of these places, as wide as given and as high as they need [px].
  FrameCanvas(const Polyline& places, int width);

  /// Widths of lines are multiples of a pen that suits the picture.
  void Line(const Polyline& places, Rgb color, double pen = 1.0);
  void DashedLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb color, double pen = 1.0);
  /// With a head at its end.
  void Arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb color, double pen = 1.0);
  /// About a place, from one direction to another [rad], with a head at its end.
  void Arc(const Eigen::Vector2d& center, double radius, double from, double to, Rgb color,
           double pen = 1.0);
  void Dot(const Eigen::Vector2d& place, Rgb color, double pen = 1.0);
  /// The outline of a robot with its driven wheels and its castors.
  void Robot(const slam::Pose2& pose, double length, double width, double track, Rgb color);
  /// Centred on the place, `size` times as large as usual.
  void Text(const Eigen::Vector2d& place, std::string_view text, Rgb color, double size = 1.0);

  /// The width of a line [m].
  double Pen() const { return pen_ / camera_.scale; }
  const Image& image() const { return image_; }
  const Camera& camera() const { return camera_; }

 private:
  Eigen::Vector2d InPicture(const Eigen::Vector2d& place) const;
  void Fill(const Polyline& convex, Rgb color);
  void Head(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, Rgb color, double pen);

  Camera camera_;
  double pen_;  // [px]
  Image image_;
};

}  // namespace ariadne::experiments
