#include "slam/map/surface_model.h"

#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {

std::vector<PlanarSurface> SurfacesInMap(const PosedCloud& scan, const ExtractSurfacesOptions& options) {
  if (options.method == SurfaceMethod::kLines && !scan.cloud_laser.organized()) {
    Fail(
        "{}: surfaces from lines need the slices of the scan, which its file does not tell; set "
        "surfaces.extract.method=region_growing",
        scan.name);
  }
  std::vector<PlanarSurface> surfaces = ExtractSurfaces(scan.cloud_laser, options);
  for (PlanarSurface& surface : surfaces) surface = Transformed(scan.T_map_laser, std::move(surface));
  return surfaces;
}

SurfaceModel MakeSurfaceModel(std::vector<PlanarSurface> surfaces_map, const SurfaceModelOptions& options) {
  SurfaceModel model;
  model.surfaces_map = UniteSurfaces(std::move(surfaces_map), options.across);
  model.classes = ClassifySurfaces(model.surfaces_map, options.objects.classes);
  model.objects = SegmentObjects(model.surfaces_map, options.objects);
  return model;
}

std::optional<double> FloorHeight(const SurfaceModel& model) {
  double sum = 0.0, area = 0.0;
  for (std::size_t i = 0; i < model.classes.size(); ++i) {
    if (model.classes[i] != SurfaceClass::kFloor) continue;
    const double piece = Area(model.surfaces_map[i]);
    sum += piece * model.surfaces_map[i].T_frame_plane.translation.z();
    area += piece;
  }
  return area > 0.0 ? std::optional(sum / area) : std::nullopt;
}

}  // namespace ariadne::slam
