#pragma once

#include <cstdint>
#include <string>

#include "drivers/simulated/world.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// What a floor plan of lines does not say.
struct PlanOptions {
  double thickness = 0.12;
  double height = 2.7;
  double door_height = 2.05;
  double door_width = 0.0;
  double furniture = 0.0;
  std::uint64_t seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("thickness", self.thickness, Unit("m"), Range{0.01, 1.0}, "of walls; a light partition wall");
    visit("height", self.height, Unit("m"), Range{0.5, 20.0}, "of the rooms");
    visit("door_height", self.door_height, Unit("m"), Range{0.3, 20.0}, "below the lintel");
    visit("door_width", self.door_width, Unit("m"), Range{0.0, 5.0},
          "wider openings at doors are narrowed to it; 0: as in the file");
    visit("furniture", self.furniture, Unit("1/m^2"), Range{0.0, 2.0},
          "pieces per square metre of room, at most; 0.15 is an office in use");
    visit("seed", self.seed, Unit(""), Range{0, 1e9}, "of the furniture's places and kinds");
  }
};

/// A floor plan in JSON, lengths in m: "walls": [[x1, y1, x2, y2], ...] with openings cut out at "doors":
/// [[x, y], ...], "start": [x, y], "spaces": [{"label", "polygon"}]. It gets walls of a thickness, a floor,
/// a ceiling, and frames and lintels at the doors; doors that lead out of all spaces are closed.
World ReadPlanWorld(const std::string& path, const PlanOptions& options = {});
World ParsePlan(const std::string& text, const std::string& name_for_errors,
                const PlanOptions& options = {});

}  // namespace ariadne::drivers
