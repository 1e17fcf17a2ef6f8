#pragma once

#include <optional>
#include <vector>

#include "slam/extract/extract_surfaces.h"
#include "slam/extract/objects.h"
#include "slam/geometry/drawing.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct SurfaceModelOptions {
  ExtractSurfacesOptions extract;
  UniteOptions across{.distance_tolerance = 0.03};
  ObjectOptions objects;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("extract", self.extract, "how the points of a scan become surfaces");
    visit("across", self.across,
          "which surfaces of several scans are one; poses and the scanner's systematic errors make them "
          "differ by more than those of one scan");
    visit("objects", self.objects, "what is structure and what an object, and the boxes around objects");
  }
};

/// What a building consists of: flat surfaces, each of a class, and boxes around what stands in it.
struct SurfaceModel {
  std::vector<PlanarSurface> surfaces_map;  // those with most points first
  std::vector<SurfaceClass> classes;        // one per surface
  std::vector<ObjectBox> objects;
};

/// The surfaces of a scan in the map frame. Error as ExtractSurfaces, with the scan's name.
std::vector<PlanarSurface> SurfacesInMap(const PosedCloud& scan, const ExtractSurfacesOptions& options);

/// Unites the surfaces of one scan or many, and tells structure from objects. The map must be level.
SurfaceModel MakeSurfaceModel(std::vector<PlanarSurface> surfaces_map, const SurfaceModelOptions& options);

/// The height of the floor, the mean over its surfaces by area; nothing where none was seen [m].
std::optional<double> FloorHeight(const SurfaceModel& model);

/// The colour of a class in pictures and drawings.
Rgb ColorOf(SurfaceClass surface_class);

/// A surface as triangles, which face the side that was seen.
TriangleMesh MeshOf(const PlanarSurface& surface, Rgb color);

/// All surfaces in the colours of their classes.
TriangleMesh MeshOf(const SurfaceModel& model);

/// The same as faces and outlines in a layer per class ("floor", "ceiling", "wall", "object"), and the
/// edges of the boxes in the layer "boxes".
Drawing DrawingOf(const SurfaceModel& model);

}  // namespace ariadne::slam
