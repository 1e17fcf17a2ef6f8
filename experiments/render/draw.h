#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/render/image.h"

namespace ariadne::experiments {

/// Drawing in pixel coordinates, anti-aliased; what lies outside of the picture is dropped. Coordinates
/// that are not finite are an Error.

/// Points joined by straight lines; a single point, or two equal ones, is a dot.
using Polyline = std::vector<Eigen::Vector2d>;

struct Stroke {
  Rgb color = kBlack;
  double width = 2.0;       // [px], at least 1
  double opacity = 1.0;     // 0 (invisible) to 1
  double halo_width = 0.0;  // of the rim on both sides that sets the line off from what is below [px]
  Rgb halo = kWhite;
};

/// Lines with round ends and joints. All lines of one call are one shape: where they cross or overlap,
/// nothing is painted twice.
void DrawPolylines(Image& canvas, const std::vector<Polyline>& lines, const Stroke& stroke);

void DrawLine(Image& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Stroke& stroke);

void FillCircle(Image& canvas, const Eigen::Vector2d& center, double radius, Rgb color,
                double opacity = 1.0);

/// A ring; half of the stroke's width lies inside of the radius, half outside.
void DrawCircle(Image& canvas, const Eigen::Vector2d& center, double radius, const Stroke& stroke);

/// A convex polygon with its corners in either sense.
void FillConvexPolygon(Image& canvas, const Polyline& corners, Rgb color, double opacity = 1.0);

/// The rectangle between two opposite corners.
void FillRectangle(Image& canvas, const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite, Rgb color,
                   double opacity = 1.0);

}  // namespace ariadne::experiments
