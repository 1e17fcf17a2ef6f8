#pragma once

#include <cstdint>

#include "drivers/simulated/thing.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// A radiator of ribs, its back at x = 0, standing off the floor.
struct Radiator {
  double length = 1.2;
  double height = 0.6;
  double depth = 0.12;
  double clearance = 0.12;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.1, 10.0}, "along y");
    visit("height", self.height, Unit("m"), Range{0.1, 3.0}, "of the ribs");
    visit("depth", self.depth, Unit("m"), Range{0.04, 0.5}, "along x");
    visit("clearance", self.clearance, Unit("m"), Range{0.0, 2.0}, "below the ribs");
  }
};
Thing Make(const Radiator& radiator);

/// A garbage can: open at the top, wider there than at the bottom.
struct GarbageCan {
  double radius = 0.16;
  double height = 0.4;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("radius", self.radius, Unit("m"), Range{0.05, 2.0}, "at the rim");
    visit("height", self.height, Unit("m"), Range{0.05, 3.0}, "");
  }
};
Thing Make(const GarbageCan& can);

/// A plant in a pot: stems, and leaves that hang outwards.
struct Plant {
  double height = 1.5;
  double spread = 0.45;
  double pot = 0.2;
  int leaves = 60;
  std::uint64_t seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{0.2, 10.0}, "of the highest leaves, from the floor");
    visit("spread", self.spread, Unit("m"), Range{0.05, 5.0}, "how far leaves reach from the middle");
    visit("pot", self.pot, Unit("m"), Range{0.05, 2.0}, "radius of the pot");
    visit("leaves", self.leaves, Unit("1"), Range{1, 2000}, "");
    visit("seed", self.seed, Unit("1"), Range{0, 1e9}, "of the leaves' places");
  }
};
Thing Make(const Plant& plant);

/// A person who stands, or is in the middle of a step, facing +x.
struct Person {
  double height = 1.75;
  double stride = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{0.5, 2.5}, "");
    visit("stride", self.stride, Unit("m"), Range{0.0, 1.0}, "between the feet: 0 stands, 0.6 walks");
  }
};
Thing Make(const Person& person);

}  // namespace ariadne::drivers
