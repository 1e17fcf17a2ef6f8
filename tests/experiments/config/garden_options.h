#pragma once

#include <string>

#include "slam/base/options.h"

/// Options of every kind, for tests of what reads, writes and describes them.
namespace ariadne::experiments {

enum class Watering { kNever, kWeekly, kDaily };

struct BedOptions {
  double width = 1.25;
  int plants = 12;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("width", self.width, Unit("m"), Range{0.1, 10.0}, "an arm reaches half of it");
    visit("plants", self.plants, Unit(""), Range{-1, 100}, "-1: as many as fit");
  }
};

struct GardenOptions {
  std::string owner = "Ada";
  Watering watering = Watering::kWeekly;
  bool fenced = true;
  double height = 0.1;
  BedOptions bed;
  BedOptions cold_frame{.width = 0.75};

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("owner", self.owner, "who picks");
    visit("watering", self.watering, "how often");
    visit("fenced", self.fenced, "against hares");
    visit("height", self.height, Unit("m"), Range{0.0, 1e6}, "of the fence");
    visit("bed", self.bed, "in the open");
    visit("cold_frame", self.cold_frame, "under glass");
  }
};

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::Watering> {
  static constexpr std::array<std::string_view, 3> value{"never", "weekly", "daily"};
};

}  // namespace ariadne
