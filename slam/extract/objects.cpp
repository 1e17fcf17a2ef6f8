#include "slam/extract/objects.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The lowest floor; minus infinity where none was seen.
double FloorHeight(std::span<const PlanarSurface> surfaces_level,
                   const std::vector<SurfaceClass>& classes) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double height = kNone;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == SurfaceClass::kFloor)
      height = std::min(height, surfaces_level[i].T_frame_plane.translation.z());
  }
  return height == kNone ? -kNone : height;
}

/// Whether the one is above the other, seen from above within its outline or nearly so.
bool IsAbove(const Box3& high, const Box3& low, double margin) {
  const auto within = [&](int axis) {
    return high.min()[axis] >= low.min()[axis] - margin && high.max()[axis] <= low.max()[axis] + margin;
  };
  return within(0) && within(1);
}

/// Gives what is higher than the robot to the first object that it is above.
void AddWhatIsAbove(std::vector<ObjectBox>& objects, const std::vector<ObjectBox>& high, double margin) {
  for (const ObjectBox& piece : high) {
    const auto below = std::ranges::find_if(
        objects, [&](const ObjectBox& object) { return IsAbove(piece.box, object.box, margin); });
    if (below != objects.end()) MergeInto(*below, piece);
  }
}

}  // namespace

std::vector<ObjectBox> SegmentObjects(std::span<const PlanarSurface> surfaces_level,
                                      const ObjectOptions& options) {
  CheckOptions(options, "objects.");
  const std::vector<SurfaceClass> classes = ClassifySurfaces(surfaces_level, options.classes);
  const double clearance = FloorHeight(surfaces_level, classes) + options.robot_height;
  std::vector<ObjectBox> objects, high;
  for (std::size_t i = 0; i < surfaces_level.size(); ++i) {
    const double area = Area(surfaces_level[i]);
    if (classes[i] != SurfaceClass::kObject || area < options.min_surface_area) continue;
    const Box3 box = BoxAround(surfaces_level[i]);
    const bool is_high = std::isfinite(clearance) && box.min().z() > clearance;
    (is_high ? high : objects).push_back({box, {i}, area});
  }
  MergeNear(objects, options.robot_size);
  AddWhatIsAbove(objects, high, 0.5 * options.robot_size);
  std::erase_if(objects, [&](const ObjectBox& object) { return object.area < options.min_object_area; });
  for (ObjectBox& object : objects) std::ranges::sort(object.surfaces);
  std::ranges::stable_sort(objects, std::ranges::greater{}, &ObjectBox::area);
  return objects;
}

}  // namespace ariadne::slam
