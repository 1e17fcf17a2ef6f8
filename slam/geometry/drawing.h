#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "slam/geometry/triangle_mesh.h"

namespace ariadne::slam {

/// Points joined by straight lines, in one frame [m].
struct Polyline3 {
  std::vector<Eigen::Vector3d> points;
  bool closed = false;  // the last point is joined to the first
};

/// What belongs together in a drawing and is shown or hidden together: a scan, or a class of things.
struct DrawingLayer {
  std::string name;  // of letters, digits, '_' and '-', which every format takes
  Rgb color;
  std::vector<Eigen::Vector3d> points;  // [m]
  std::vector<Polyline3> lines;
  TriangleMesh mesh;
};

/// Points, lines and faces in layers, as CAD programs know them; z up. In a plan, z is 0.
struct Drawing {
  std::vector<DrawingLayer> layers;
};

}  // namespace ariadne::slam
