#pragma once

#include "slam/base/options.h"

namespace ariadne::experiments {

/// What must be so before a robot leaves.
struct PreflightOptions {
  double min_battery = 22.0;
  double max_battery = 30.0;
  double min_free = 5.0;
  double min_valid = 0.3;
  double patience = 15.0;
  bool scan = true;
  double max_floor_height = 0.05;
  double max_floor_slope = 0.015;
  bool uncalibrated = false;
  double press_stop = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("min_battery", self.min_battery, Unit("V"), Range{0.0, 100.0},
          "of the motors; 22 V are two lead batteries that are nearly empty");
    visit("max_battery", self.max_battery, Unit("V"), Range{0.0, 100.0}, "of the motors");
    visit(
        "min_free", self.min_free, Unit("GB"), Range{0.0, 1e6},
        "on the disk of the run: an hour of sweeps at 75 Hz takes up to 0.2 GB, its scans and model more");
    visit("min_valid", self.min_valid, Unit(""), Range{0.0, 1.0},
          "share of the beams of a level sweep that must have a distance");
    visit("patience", self.patience, Unit("s"), Range{0.5, 1000.0}, "for a device that does not answer");
    visit("scan", self.scan, "take a 3D scan, and see whether the floor is where the mount says");
    visit("max_floor_height", self.max_floor_height, Unit("m"), Range{0.0, 1.0}, "of that floor, from 0");
    visit("max_floor_slope", self.max_floor_slope, Unit(""), Range{0.0, 1.0},
          "of that floor; more is a mount that has been knocked, or a ramp");
    visit("uncalibrated", self.uncalibrated,
          "accept a mount without roll and pitch, as before the first calibration");
    visit("press_stop", self.press_stop, Unit("s"), Range{0.0, 600.0},
          "wait so long for somebody to press and release the emergency stop; 0: it is not tried");
  }
};

}  // namespace ariadne::experiments
