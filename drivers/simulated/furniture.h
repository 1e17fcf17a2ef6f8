#pragma once

#include <cstdint>

#include "drivers/simulated/thing.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// Four legs under a plate that juts out over them.
struct Table {
  double length = 1.6;
  double width = 0.8;
  double height = 0.74;
  double plate = 0.03;
  double overhang = 0.08;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.2, 20.0}, "along y, where one sits");
    visit("width", self.width, Unit("m"), Range{0.2, 10.0}, "along x");
    visit("height", self.height, Unit("m"), Range{0.1, 3.0}, "of the plate's upper side");
    visit("plate", self.plate, Unit("m"), Range{0.005, 0.1}, "thickness of the plate");
    visit("overhang", self.overhang, Unit("m"), Range{0.0, 0.5}, "of the plate over the legs");
  }
};
Thing Make(const Table& table);

/// A chair with a back, its front towards +x.
struct Chair {
  double seat = 0.46;
  double height = 0.92;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("seat", self.seat, Unit("m"), Range{0.2, 1.0}, "height of the seat");
    visit("height", self.height, Unit("m"), Range{0.3, 2.0}, "height of the back");
  }
};
Thing Make(const Chair& chair);

/// Boards between sides, before a back, with folders and books on them.
struct Shelf {
  double length = 1.0;
  double depth = 0.35;
  double height = 2.0;
  int boards = 6;
  double filled = 0.7;
  std::uint64_t seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.1, 20.0}, "along y");
    visit("depth", self.depth, Unit("m"), Range{0.1, 2.0}, "along x");
    visit("height", self.height, Unit("m"), Range{0.2, 5.0}, "of the sides");
    visit("boards", self.boards, Unit("1"), Range{2, 20}, "the lowest and the highest too");
    visit("filled", self.filled, Unit("1"), Range{0.0, 1.0}, "share of the boards that is in use");
    visit("seed", self.seed, Unit("1"), Range{0, 1e9}, "of the books' sizes");
  }
};
Thing Make(const Shelf& shelf);

/// A closed block, on the floor or above it: cupboard, bench, lamp, notice board.
struct Block {
  double length = 1.0;
  double depth = 0.5;
  double height = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.001, 1000.0}, "along y");
    visit("depth", self.depth, Unit("m"), Range{0.001, 1000.0}, "along x");
    visit("height", self.height, Unit("m"), Range{0.001, 100.0}, "along z");
  }
};
Thing Make(const Block& block);

/// An upright cylinder: a round pillar, a pipe, a fire extinguisher.
struct Cylinder {
  double radius = 0.2;
  double height = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("radius", self.radius, Unit("m"), Range{0.005, 100.0}, "");
    visit("height", self.height, Unit("m"), Range{0.005, 100.0}, "");
  }
};
Thing Make(const Cylinder& cylinder);

}  // namespace ariadne::drivers
