#include "slam/extract/extract_surfaces.h"

namespace ariadne::slam {

std::vector<PlanarSurface> ExtractSurfaces(const PointCloud& cloud_laser,
                                           const ExtractSurfacesOptions& options) {
  switch (options.method) {
    case SurfaceMethod::kLines:
      return UniteSurfaces(GrowSurfaces(cloud_laser, options.lines, options.surfaces), options.unite);
    case SurfaceMethod::kRegionGrowing:
      return UniteSurfaces(GrowRegions(cloud_laser, options.regions), options.unite);
  }
  return {};
}

}  // namespace ariadne::slam
