#pragma once

#include <span>
#include <vector>

#include "drivers/robot.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// When the difference of two range frames of a standing 2D scanner is motion (Sec. 3.4, which leaves the
/// thresholds open).
struct DifferentialFrameOptions {
  double period = 0.3;
  double min_difference = 0.2;
  int min_adjacent_beams = 3;
  double max_range = 15.0;
  int max_repeats = 5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("period", self.period, Unit("s"), Range{0.01, 10.0},
          "between frames; a person walks 0.4 m meanwhile, more than its own depth");
    visit("min_difference", self.min_difference, Unit("m"), Range{1e-3, 100.0},
          "of a beam's ranges; noise and rounding stay below 3 cm, a step of a person is 40 cm and more");
    visit("min_adjacent_beams", self.min_adjacent_beams, Unit(""), Range{1, 1000},
          "that change together; at edges single beams change with the noise, a leg 6 m away is 2 to 3 "
          "beams of 0.5 deg wide and uncovers as many");
    visit("max_range", self.max_range, Unit("m"), Range{0.1, 1000.0},
          "ranges are cut here, and no return counts as this far; within it the paper plans");
    visit("max_repeats", self.max_repeats, Unit(""), Range{0, 1000},
          "scans that are taken again before one is kept in spite of motion; open, some 20 s of patience");
  }
};

/// Adjacent beams of one scanner that changed from one frame to the next.
struct MovedBeams {
  std::size_t scanner = 0;     // index within a frame
  std::size_t first_beam = 0;  // of the scanner's sweep
  std::size_t last_beam = 0;   // included
  double from_stamp = 0.0;     // of the frame before [s]
  double to_stamp = 0.0;       // of the frame that differs from it [s]
  double difference = 0.0;     // largest change of range [m]
};

/// The runs of adjacent beams whose ranges differ between two sweeps of one standing scanner. No return
/// counts as further away than max_range. `scanner` is copied into the result. The sweeps must have the
/// same number of beams.
std::vector<MovedBeams> DifferenceOf(const slam::LaserSweep& before, const slam::LaserSweep& after,
                                     const DifferentialFrameOptions& options, std::size_t scanner = 0);

/// What moved while the robot stood: each frame, all sweeps taken at a time, is subtracted from the one
/// before it. Empty: nothing moved. All frames must have the same scanners in the same order.
std::vector<MovedBeams> DetectMotion(std::span<const std::vector<SafetySweep>> frames,
                                     const DifferentialFrameOptions& options);

}  // namespace ariadne::drivers
