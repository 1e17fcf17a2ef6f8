#include "slam/extract/classify_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ariadne::slam {
namespace {

/// What the rules ask of a surface.
struct Shape {
  Plane3 plane;
  Box3 box;
  double area = 0.0;    // [m^2]
  double length = 0.0;  // level extent along the surface [m]
};

/// Heights of floor and ceiling; infinite where none was seen.
struct Levels {
  double floor = -std::numeric_limits<double>::infinity();
  double ceiling = std::numeric_limits<double>::infinity();
};

double LevelExtent(const PlanarSurface& surface, const Plane3& plane) {
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(plane.normal);
  if (along.norm() < 1e-9) return 0.0;  // the surface is level itself
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<Eigen::Vector3d>& ring : OutlinePoints(surface)) {
    for (const Eigen::Vector3d& p : ring) {
      low = std::min(low, along.normalized().dot(p));
      high = std::max(high, along.normalized().dot(p));
    }
  }
  return std::max(0.0, high - low);
}

Shape ShapeOf(const PlanarSurface& surface) {
  const Plane3 plane = PlaneOf(surface);
  return {plane, BoxAround(surface), Area(surface), LevelExtent(surface, plane)};
}

double HeightOf(const Shape& shape) { return shape.box.center().z(); }
bool FacesUp(const Shape& shape, const ClassifyOptions& options) {
  return shape.plane.normal.z() > std::cos(options.max_tilt);
}
bool FacesDown(const Shape& shape, const ClassifyOptions& options) {
  return shape.plane.normal.z() < -std::cos(options.max_tilt);
}
bool IsUpright(const Shape& shape, const ClassifyOptions& options) {
  return std::abs(shape.plane.normal.z()) < std::sin(options.max_tilt);
}

Levels FindLevels(const std::vector<Shape>& shapes, const ClassifyOptions& options) {
  Levels levels;
  bool has_floor = false, has_ceiling = false;
  for (const Shape& shape : shapes) {
    if (shape.area < options.level_area) continue;
    const double height = HeightOf(shape);
    if (FacesUp(shape, options) && (!has_floor || height < levels.floor)) {
      levels.floor = height;
      has_floor = true;
    }
    if (FacesDown(shape, options) && (!has_ceiling || height > levels.ceiling)) {
      levels.ceiling = height;
      has_ceiling = true;
    }
  }
  return levels;
}

/// Whether next to nothing was seen behind the plane.
bool BoundsTheScene(const Shape& wall, const std::vector<Shape>& shapes, const ClassifyOptions& options) {
  double all = 0.0, behind = 0.0;
  for (const Shape& shape : shapes) {
    all += shape.area;
    if (wall.plane.Distance(shape.box.center()) < -options.behind_distance) behind += shape.area;
  }
  return behind <= options.behind_share * all;
}

SurfaceClass ClassOf(const Shape& shape, const std::vector<Shape>& shapes, const Levels& levels,
                     const ClassifyOptions& options) {
  const double height = HeightOf(shape);
  if (FacesUp(shape, options) && std::abs(height - levels.floor) <= options.level_tolerance) {
    return SurfaceClass::kFloor;
  }
  if (FacesDown(shape, options)) {
    const bool highest = height >= levels.ceiling - options.level_tolerance;
    const bool overhead = std::isfinite(levels.floor) && height >= levels.floor + options.ceiling_height;
    return highest || overhead ? SurfaceClass::kCeiling : SurfaceClass::kObject;
  }
  if (IsUpright(shape, options) && shape.length >= options.wall_length) {
    const bool high = shape.box.max().z() >= levels.ceiling - options.below_ceiling;
    if (high || BoundsTheScene(shape, shapes, options)) return SurfaceClass::kWall;
  }
  return SurfaceClass::kObject;
}

bool IsFlush(const Shape& shape, const Shape& wall, const ClassifyOptions& options) {
  if (shape.plane.normal.dot(wall.plane.normal) < std::cos(options.max_tilt)) return false;
  return std::abs(wall.plane.Distance(shape.box.center())) <= options.flush;
}

}  // namespace

std::vector<SurfaceClass> ClassifySurfaces(std::span<const PlanarSurface> surfaces_level,
                                           const ClassifyOptions& options) {
  CheckOptions(options, "classes.");
  std::vector<Shape> shapes;
  for (const PlanarSurface& surface : surfaces_level) shapes.push_back(ShapeOf(surface));
  const Levels levels = FindLevels(shapes, options);
  std::vector<SurfaceClass> classes;
  for (const Shape& shape : shapes) classes.push_back(ClassOf(shape, shapes, levels, options));
  std::vector<std::size_t> walls;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (classes[i] == SurfaceClass::kWall) walls.push_back(i);
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (classes[i] != SurfaceClass::kObject) continue;
    const auto is_flush = [&](std::size_t w) { return IsFlush(shapes[i], shapes[w], options); };
    if (std::ranges::any_of(walls, is_flush)) classes[i] = SurfaceClass::kWall;
  }
  return classes;
}

}  // namespace ariadne::slam
