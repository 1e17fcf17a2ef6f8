#pragma once

#include <vector>

#include "drivers/simulated/ray_scene.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// How a 2D range finder sits on the robot and where its mirror is.
struct SweepMounting {
  slam::Pose3 T_base_laser;  // at pitch 0; the origin lies on the tilt axis
  slam::ScannerModel scanner;
  std::size_t beams = 181;
  double mirror_forward = 0.0;  // of the mirror's centre from the tilt axis, at pitch 0 [m]
  double mirror_up = 0.0;       // [m]
};

/// Angles and times of a sweep over 180 deg for which the mirror turns once, twice or four times.
slam::ScannerModel HalfCircle(int turns);
std::size_t HalfCircleBeams(int turns);  // 181, 361 or 721

/// The beams of a sweep that starts at `stamp` [s] with `pitch` [rad], as rays at their own time, pitch and
/// place of the base.
std::vector<Ray> SweepBeams(const SweepMounting& mounting, const Motion& T_map_base, double stamp,
                            double pitch, double pitch_rate);

/// The motion of what does not move.
Motion Standing(const slam::Pose3& T_map_body);

}  // namespace ariadne::drivers
