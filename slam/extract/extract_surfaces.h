#pragma once

#include <array>

#include "slam/extract/grow_surfaces.h"
#include "slam/extract/region_growing.h"
#include "slam/extract/unite_surfaces.h"

namespace ariadne::slam {

/// How the points of a scan become surfaces.
enum class SurfaceMethod {
  kLines,          // the paper's: from lines of successive slices (Sec. 2.2.1 step 3)
  kRegionGrowing,  // beside it
};

struct ExtractSurfacesOptions {
  SurfaceMethod method = SurfaceMethod::kLines;
  LineOptions lines;
  SurfaceOptions surfaces;
  RegionGrowingOptions regions;
  UniteOptions unite;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method,
          "lines is the paper's (2.2.1) and keeps up with the scanner; region_growing also takes clouds "
          "without slices");
    visit("lines", self.lines, "of lines: the detector in the slices");
    visit("surfaces", self.surfaces, "of lines: how they grow into surfaces");
    visit("regions", self.regions, "of region_growing");
    visit("unite", self.unite, "which surfaces are one");
  }
};

/// The flat surfaces of a scan in the laser frame, those with most points first, overlapping ones united.
/// Error where the method needs slices and the cloud has none, or an option is out of its range.
std::vector<PlanarSurface> ExtractSurfaces(const PointCloud& cloud_laser,
                                           const ExtractSurfacesOptions& options);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::SurfaceMethod> {
  static constexpr std::array<std::string_view, 2> value{"lines", "region_growing"};
};

}  // namespace ariadne
