#pragma once

#include <array>

#include "drivers/simulated/range_finder_options.h"
#include "slam/geometry/angles.h"

namespace ariadne::drivers {

/// Points of a slice over 180 deg: the mirror turns once, twice or four times for them (Sec. 2.2).
enum class SlicePoints { k181, k361, k721 };

/// The AIS 3D laser range finder: a 2D range finder that one servo pitches about a horizontal axis.
struct AisScannerOptions {
  SlicePoints points = SlicePoints::k181;
  int slices = 256;
  double lowest_pitch = slam::RadFromDeg(-55.0);
  double highest_pitch = slam::RadFromDeg(65.0);
  double mount_x = 0.25;
  double mount_y = 0.0;
  double mount_z = 0.95;
  double mirror_forward = 0.0;
  double mirror_up = 0.0;
  RangeFinderOptions range_finder;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("points", self.points, "per slice of 13.3, 26.7 or 53.3 ms (Sec. 2.2)");
    visit("slices", self.slices, Unit(""), Range{1, 10000}, "256 or 128 in Sec. 2.2");
    visit("lowest_pitch", self.lowest_pitch, Unit("rad"), Range{-1.58, 1.58},
          "where the tilt starts, -55 deg; the paper gives 120 deg of aperture and leaves the limits open");
    visit("highest_pitch", self.highest_pitch, Unit("rad"), Range{-1.58, 1.58},
          "where the tilt ends, 65 deg: ceilings 1 m away are seen, and the floor from 0.7 m on");
    visit("mount_x", self.mount_x, Unit("m"), Range{-10.0, 10.0},
          "the tilt axis, ahead of the middle of the driven wheels; open, in the front third of 80 cm");
    visit("mount_y", self.mount_y, Unit("m"), Range{-10.0, 10.0}, "to the left");
    visit("mount_z", self.mount_z, Unit("m"), Range{0.0, 10.0},
          "above the floor; open, on top of a platform of 90 cm");
    visit("mirror_forward", self.mirror_forward, Unit("m"), Range{-1.0, 1.0},
          "the mirror's centre ahead of the tilt axis, at pitch 0; later papers put it onto the axis");
    visit("mirror_up", self.mirror_up, Unit("m"), Range{-1.0, 1.0}, "and above it");
    visit("range_finder", self.range_finder, "the 2D device in the mount");
  }
};

}  // namespace ariadne::drivers

namespace ariadne {

template <>
struct EnumNames<drivers::SlicePoints> {
  static constexpr std::array<std::string_view, 3> value{"181", "361", "721"};
};

}  // namespace ariadne
