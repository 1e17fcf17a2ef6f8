#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/draw.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// Marks on a finished picture, made with the camera of the picture. They lie on top of everything.

/// A path as a line through points of the map; what lies behind a perspective camera is cut off.
void DrawPath(Image& canvas, const Camera& camera, const std::vector<Eigen::Vector3d>& path_map,
              const Stroke& stroke = {.width = 3.0, .halo_width = 1.5});

/// A box of the map by its edges: an object, the region that another picture shows.
void DrawBox(Image& canvas, const Camera& camera, const Eigen::AlignedBox3d& box_map,
             const Stroke& stroke = {.width = 2.0});

struct PoseStyle {
  double radius = 0.0;           // of a mark [px]; 0: 1.2 % of the picture's width, at least 8
  bool colored_by_index = true;  // the categorical colours, as ColoredByScan; else `color`
  Rgb color = {40, 40, 40};
  bool show_numbers = true;
  int first_number = 0;
};

/// Poses as numbered discs with a small triangle that points to where the pose's x axis (forward) points.
void DrawPoses(Image& canvas, const Camera& camera, const std::vector<slam::Pose3>& T_map_laser,
               const PoseStyle& style = {});

}  // namespace ariadne::experiments
