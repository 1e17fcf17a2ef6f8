#pragma once

#include <vector>

namespace ariadne::drivers {

/// Where the mount was at a time.
struct Tilt {
  double angle = 0.0;  // [rad]
  double rate = 0.0;   // [rad/s]
};

/// What a servo has measured of its own motion. Its steps are coarse (1.5 mrad), and it moves evenly, so a
/// line through what it measured around a time errs less than one through the two next to it.
class TiltTrack {
 public:
  /// `window` [s] is how long a span that line is of.
  explicit TiltTrack(double window) : window_(window) {}

  /// Times ascend [s].
  void Add(double time, double angle);

  /// Error with fewer than two measurements.
  Tilt At(double time) const;

 private:
  struct Sample {
    double time;
    double angle;
  };

  double window_;
  std::vector<Sample> samples_;
};

}  // namespace ariadne::drivers
