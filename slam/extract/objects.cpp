#include "slam/extract/objects.h"

#include <algorithm>

namespace ariadne::slam {
namespace {

void MergeInto(ObjectBox& object, const ObjectBox& other) {
  object.box.extend(other.box);
  object.surfaces.insert(object.surfaces.end(), other.surfaces.begin(), other.surfaces.end());
  object.area += other.area;
}

/// A merged box may reach boxes that neither of its parts reached, so it looks at all others again.
void MergeNear(std::vector<ObjectBox>& objects, double distance) {
  for (std::size_t i = 0; i < objects.size();) {
    bool merged = false;
    for (std::size_t j = objects.size(); j-- > 0;) {
      if (j == i || objects[i].box.exteriorDistance(objects[j].box) >= distance) continue;
      MergeInto(objects[i], objects[j]);
      objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(j));
      if (j < i) --i;
      merged = true;
    }
    if (!merged) ++i;
  }
}

}  // namespace

std::vector<ObjectBox> SegmentObjects(std::span<const PlanarSurface> surfaces_level,
                                      const ObjectOptions& options) {
  CheckOptions(options, "objects.");
  const std::vector<SurfaceClass> classes = ClassifySurfaces(surfaces_level, options.classes);
  std::vector<ObjectBox> objects;
  for (std::size_t i = 0; i < surfaces_level.size(); ++i) {
    const double area = Area(surfaces_level[i]);
    if (classes[i] != SurfaceClass::kObject || area < options.min_surface_area) continue;
    objects.push_back({BoxAround(surfaces_level[i]), {i}, area});
  }
  MergeNear(objects, options.robot_size);
  std::erase_if(objects, [&](const ObjectBox& object) { return object.area < options.min_object_area; });
  for (ObjectBox& object : objects) std::ranges::sort(object.surfaces);
  std::ranges::stable_sort(objects, std::ranges::greater{}, &ObjectBox::area);
  return objects;
}

}  // namespace ariadne::slam
