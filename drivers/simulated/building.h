#pragma once

#include <array>

#include "drivers/simulated/thing.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// Where the leaf of a door hangs, seen along the wall.
enum class Hinge { kNone, kStart, kEnd };

/// A hole in a wall: a passage, a door, a window.
struct Opening {
  double at = 0.0;
  double width = 0.9;
  double bottom = 0.0;
  double top = 2.0;
  double frame = 0.0;
  Hinge hinge = Hinge::kNone;
  double angle = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("at", self.at, Unit("m"), Range{0.0, 10000.0}, "of its middle, from the wall's start");
    visit("width", self.width, Unit("m"), Range{0.05, 1000.0}, "");
    visit("bottom", self.bottom, Unit("m"), Range{0.0, 100.0},
          "over the wall's foot: the sill of a window");
    visit("top", self.top, Unit("m"), Range{0.05, 100.0}, "over the wall's foot: the lintel is above it");
    visit("frame", self.frame, Unit("m"), Range{0.0, 0.5},
          "how far a frame stands out of the wall; 0: none");
    visit("hinge", self.hinge, "the side on which a door leaf hangs");
    visit("angle", self.angle, Unit("deg"), Range{-180.0, 180.0},
          "of the leaf: 0 closed, positive to the wall's left");
  }
};

/// A straight wall around the line from its start at the origin along +x.
struct Wall {
  double length = 1.0;
  double thickness = 0.15;
  double height = 2.7;
  std::vector<Opening> openings;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("thickness", self.thickness, Unit("m"), Range{0.01, 10.0},
          "half of it on either side of the line");
    visit("height", self.height, Unit("m"), Range{0.05, 100.0}, "");
  }
};
/// An Error where openings overlap or leave the wall.
Thing Make(const Wall& wall);

/// A straight flight that rises along +x from the origin; its middle is y = 0.
struct Staircase {
  double width = 1.4;
  int steps = 10;
  double rise = 0.17;
  double run = 0.29;
  double railing = 0.9;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("width", self.width, Unit("m"), Range{0.3, 50.0}, "along y");
    visit("steps", self.steps, Unit("1"), Range{1, 500}, "");
    visit("rise", self.rise, Unit("m"), Range{0.02, 1.0}, "of a step");
    visit("run", self.run, Unit("m"), Range{0.05, 5.0}, "of a step");
    visit("railing", self.railing, Unit("m"), Range{0.0, 2.0}, "height on both sides; 0: none");
  }
};
Thing Make(const Staircase& stairs);

/// The front of an elevator in a wall that lies behind x = 0: frame, two leaves, a panel with the button.
struct Elevator {
  double width = 1.1;
  double height = 2.1;
  double open = 0.0;
  double depth = 1.4;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("width", self.width, Unit("m"), Range{0.3, 10.0}, "of the door");
    visit("height", self.height, Unit("m"), Range{0.5, 10.0}, "of the door");
    visit("open", self.open, Unit("1"), Range{0.0, 1.0}, "share of the width that is open");
    visit("depth", self.depth, Unit("m"), Range{0.2, 10.0}, "of the cabin");
  }
};
Thing Make(const Elevator& elevator);

/// Posts and a handrail along +x from the origin, with two bars between.
struct Railing {
  double length = 2.0;
  double height = 0.95;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.1, 1000.0}, "along x");
    visit("height", self.height, Unit("m"), Range{0.2, 3.0}, "");
  }
};
Thing Make(const Railing& railing);

}  // namespace ariadne::drivers

template <>
struct ariadne::EnumNames<ariadne::drivers::Hinge> {
  static constexpr std::array<std::string_view, 3> value = {"none", "start", "end"};
};
