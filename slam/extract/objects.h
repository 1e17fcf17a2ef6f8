#pragma once

#include "slam/extract/classify_surfaces.h"

namespace ariadne::slam {

struct ObjectOptions {
  double robot_size = 0.6;
  double robot_height = 1.3;
  double min_surface_area = 0.03;
  double min_object_area = 0.08;
  ClassifyOptions classes;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "robot_size", self.robot_size, Unit("m"), Range{0.0, 10.0},
        "boxes nearer to each other are merged, as the robot cannot pass between them (2.2.1); its width, "
        "60 cm (2.1)");
    visit(
        "robot_height", self.robot_height, Unit("m"), Range{0.0, 100.0},
        "what hangs higher above the floor is no obstacle, as the robot passes below: beams, lamps, signs; "
        "the scanner on top of the robot ends at 1.1 m");
    visit("min_surface_area", self.min_surface_area, Unit("m^2"), Range{0.0, 100.0},
          "of a surface that gets a box (\"large\", open): a part of a person or of a chair");
    visit("min_object_area", self.min_object_area, Unit("m^2"), Range{0.0, 100.0},
          "of all surfaces of an object: single small ones are errors more often than things");
    visit("classes", self.classes, "what is structure, and gets no box");
  }
};

/// Something that stands in a room.
struct ObjectBox {
  Box3 box;                           // along the axes of the level frame [m]
  std::vector<std::size_t> surfaces;  // of which it consists, ascending
  double area = 0.0;                  // of these [m^2]
};

/// Boxes around the surfaces that are neither floor nor ceiling nor wall, merged until none are closer than
/// the robot's size (Sec. 2.2.1 step 4), those with most area first. As walls, floor and ceiling get no
/// box, they do not join what stands in the room; nor does what hangs above the robot, which only belongs
/// to an object that it is right above. The frame must be level; see ClassifySurfaces.
std::vector<ObjectBox> SegmentObjects(std::span<const PlanarSurface> surfaces_level,
                                      const ObjectOptions& options);

}  // namespace ariadne::slam
