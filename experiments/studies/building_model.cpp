#include "experiments/studies/building_model.h"

#include <fmt/format.h>

#include "slam/base/numbers.h"
#include "slam/map/layer_names.h"
#include "slam/reduce/reduce.h"

namespace ariadne::experiments {
namespace {

slam::DrawingLayer PathOf(std::span<const slam::PosedCloud> scans) {
  slam::Polyline3 path;
  for (const slam::PosedCloud& scan : scans) path.points.push_back(scan.T_map_laser.translation);
  slam::DrawingLayer layer{"path", {30, 90, 200}, path.points, {}, {}};
  if (path.points.size() > 1) layer.lines.push_back(std::move(path));
  return layer;
}

/// Each scan's points, thinned, in a layer of its own.
std::vector<slam::DrawingLayer> PointLayers(std::span<const slam::PosedCloud> scans, double edge) {
  std::vector<std::string> names;
  for (const slam::PosedCloud& scan : scans) names.push_back(scan.name);
  names = slam::LayerNames("points_", names);
  std::vector<slam::DrawingLayer> layers;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    slam::PointCloud points = slam::ReduceVoxels(scans[i].cloud_laser, edge);
    points = slam::Transformed(scans[i].T_map_laser, std::move(points));
    layers.push_back({names[i], {120, 120, 120}, std::move(points.positions), {}, {}});
  }
  return layers;
}

}  // namespace

slam::Octree MakeOctree(const RunScans& scans, const ModelOptions& options, const ModelProgress& progress) {
  slam::Octree octree(options.octree);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    progress("octree", i, scans.size());
    const slam::PosedCloud scan = scans.Read(i);
    octree.Add(slam::Transformed(scan.T_map_laser, scan.cloud_laser), scan.T_map_laser.translation);
  }
  return octree;
}

slam::SurfaceModel MakeSurfaces(const RunScans& scans, const ModelOptions& options,
                                const ModelProgress& progress) {
  std::vector<slam::PlanarSurface> surfaces_map;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    progress("surfaces", i, scans.size());
    for (slam::PlanarSurface& surface : slam::SurfacesInMap(scans.Read(i), options.surfaces.extract))
      surfaces_map.push_back(std::move(surface));
  }
  return slam::MakeSurfaceModel(std::move(surfaces_map), options.surfaces);
}

std::vector<double> PlanHeights(const ModelOptions& options) {
  return ParseNumbers(options.plan_heights, "plan_heights");
}

double FloorOf(const slam::SurfaceModel& model) { return slam::FloorHeight(model).value_or(0.0); }

slam::OccupancyGrid MakeGrid(double floor, std::span<const slam::PosedCloud> scans,
                             const ModelOptions& options) {
  slam::OccupancyGridOptions grid = options.grid;
  grid.min_height += floor;
  grid.max_height += floor;
  return slam::MakeOccupancyGrid(scans, grid);
}

slam::Drawing PlanAt(double height, double floor, std::span<const slam::PosedCloud> scans,
                     const ModelOptions& options) {
  slam::LineMapOptions plan = options.plan;
  plan.slice.height = floor + height;
  slam::Drawing drawing = slam::DrawingOf(slam::MakeLineMap(scans, plan));
  slam::DrawingLayer path = PathOf(scans);
  for (Eigen::Vector3d& p : path.points) p.z() = 0.0;
  for (slam::Polyline3& line : path.lines) {
    for (Eigen::Vector3d& p : line.points) p.z() = 0.0;
  }
  drawing.layers.push_back(std::move(path));
  return drawing;
}

slam::Drawing MakeDrawing(const slam::SurfaceModel& model, std::span<const slam::PosedCloud> scans,
                          const ModelOptions& options) {
  slam::Drawing drawing = slam::DrawingOf(model);
  for (slam::DrawingLayer& layer : PointLayers(scans, options.drawing_points))
    drawing.layers.push_back(std::move(layer));
  drawing.layers.push_back(PathOf(scans));
  return drawing;
}

}  // namespace ariadne::experiments
