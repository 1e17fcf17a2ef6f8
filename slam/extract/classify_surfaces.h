#pragma once

#include <array>
#include <span>
#include <vector>

#include "slam/base/options.h"
#include "slam/extract/planar_surface.h"

namespace ariadne::slam {

/// What a surface belongs to: the structure of the building, or something that stands in it.
enum class SurfaceClass { kFloor, kCeiling, kWall, kObject };

struct ClassifyOptions {
  double max_tilt = 0.17;
  double level_area = 1.0;
  double level_tolerance = 0.15;
  double ceiling_height = 1.9;
  double wall_length = 1.0;
  double below_ceiling = 0.5;
  double behind_distance = 0.3;
  double behind_share = 0.03;
  double flush = 0.15;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_tilt", self.max_tilt, Unit("rad"), Range{0.0, 0.7},
          "of level and of upright surfaces, 10 deg: a robot that stands stands nearly level");
    visit("level_area", self.level_area, Unit("m^2"), Range{0.0, 1000.0},
          "the lowest level surface of this size that faces up is the floor; smaller ones may be errors");
    visit("level_tolerance", self.level_tolerance, Unit("m"), Range{0.0, 5.0},
          "other pieces of floor are that much above or below; more than a door sill, less than a chair");
    visit("ceiling_height", self.ceiling_height, Unit("m"), Range{0.0, 100.0},
          "level surfaces that face down are ceiling from this height above the floor on, so that lintels "
          "and beams are, and the undersides of tables are not");
    visit("wall_length", self.wall_length, Unit("m"), Range{0.0, 100.0},
          "of an upright surface, level; wider than a person or a door leaf");
    visit("below_ceiling", self.below_ceiling, Unit("m"), Range{0.0, 100.0},
          "a wall ends no lower; a cupboard does");
    visit("behind_distance", self.behind_distance, Unit("m"), Range{0.0, 100.0},
          "or a wall is a surface beyond which nothing is seen: nothing farther behind its plane, thick "
          "walls and pilasters aside,");
    visit("behind_share", self.behind_share, Unit(""), Range{0.0, 1.0},
          "but for this share of all area, seen through mirrors and doors ajar");
    visit("flush", self.flush, Unit("m"), Range{0.0, 10.0},
          "what is parallel to a wall and that near to its plane is part of it: doors in their frames, "
          "boards, short "
          "pieces between two cupboards");
  }
};

/// One class per surface. The frame must be level, z up, and normals face the side that was seen, as those
/// of ExtractSurfaces do: the laser frame of a robot on an even floor, or the map.
///
/// Level surfaces at the floor's height that face up are floor, and those overhead that face down are
/// ceiling. Upright surfaces are walls if they are long and either end near the ceiling or bound the
/// scene; so is what lies flush with a wall. All else are objects, among them pillars and sloped surfaces.
std::vector<SurfaceClass> ClassifySurfaces(std::span<const PlanarSurface> surfaces_level,
                                           const ClassifyOptions& options);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::SurfaceClass> {
  static constexpr std::array<std::string_view, 4> value{"floor", "ceiling", "wall", "object"};
};

}  // namespace ariadne
