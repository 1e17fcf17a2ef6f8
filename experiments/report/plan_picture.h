#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "experiments/render/annotations.h"
#include "experiments/render/camera.h"
#include "experiments/render/draw.h"
#include "planning/view/view_planner.h"
#include "slam/geometry/drawing.h"

namespace ariadne::experiments {

/// Colours of plans. Seen and unseen edges also differ by their dashes, for prints without colour.
struct PlanColors {
  static constexpr Rgb kFree{238, 243, 248};
  static constexpr Rgb kPoint{70, 78, 90};
  static constexpr Rgb kSeen{24, 30, 40};
  static constexpr Rgb kUnseen{222, 74, 36};
  static constexpr Rgb kCandidate{52, 120, 190};
  static constexpr Rgb kRobot{20, 128, 84};
  static constexpr Rgb kView{150, 60, 170};
};

using Segment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/// A picture of a plan from above, drawn in map coordinates [m].
class PlanCanvas {
 public:
  /// Shows all of these places, as wide as given and as high as they need [px].
  PlanCanvas(std::span<const Eigen::Vector2d> places_map, int width);

  void Area(std::span<const planning::LabelledPolygon> area);
  /// Seen edges as solid lines, unseen ones dashed.
  void Edges(std::span<const planning::LabelledPolygon> area, double width = 3.0);
  void Points(std::span<const Eigen::Vector2d> points_map, Rgb color, double radius);
  void Lines(std::span<const Segment> lines_map, const Stroke& stroke);
  void Dashes(std::span<const Segment> lines_map, const Stroke& stroke);
  /// An arrow's head about the place.
  void Robot(const slam::Pose2& T_map_robot, Rgb color);
  /// Centred on the place, moved by some pixels.
  void Text(const Eigen::Vector2d& p_map, std::string_view text, Rgb color,
            const Eigen::Vector2d& shift = Eigen::Vector2d::Zero());

  double PixelsPerMeter() const { return camera_.scale; }
  /// With its scale bar, under a title.
  Image Finished(std::string_view title) const;

 private:
  Eigen::Vector2d InPicture(const Eigen::Vector2d& p_map) const;

  Camera camera_;
  Projector project_;
  Image image_;
};

/// The corners of all rings.
std::vector<Eigen::Vector2d> CornersOf(std::span<const planning::LabelledPolygon> area);

/// The edges with one label.
std::vector<Segment> SegmentsOf(std::span<const planning::LabelledPolygon> area, bool seen);

/// A straight way in pieces with gaps [m].
std::vector<Segment> Dashed(const Segment& line, double dash, double gap);

/// What a view is to show: its rays to what they meet, those that meet unseen edges apart.
struct ViewRays {
  std::vector<Segment> unseen, other;
};
ViewRays RaysOf(const planning::View& view, std::span<const planning::LabelledPolygon> area,
                const slam::Pose2& T_map_robot, const planning::RayGainOptions& options);

/// A segment per line, in a layer of a drawing.
slam::DrawingLayer LayerOf(const std::string& name, Rgb color, std::span<const Segment> lines_map);
slam::DrawingLayer LayerOf(const std::string& name, Rgb color, std::span<const Eigen::Vector2d> points_map);

}  // namespace ariadne::experiments
