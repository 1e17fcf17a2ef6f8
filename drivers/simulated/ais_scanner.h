#pragma once

#include "drivers/simulated/ais_scanner_options.h"
#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/sweep_beams.h"
#include "slam/base/parallel.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// Where the scanner sits and how its mirror turns. The laser frame is the one at pitch 0: its origin is on
/// the tilt axis, x forward, y left, z up. A mirror that is off the axis (mirror_forward, mirror_up) moves
/// with the pitch, which a Scan cannot say: its points are then wrong by up to that offset, as those of a
/// real scanner that is built so and not calibrated.
SweepMounting AisMounting(const AisScannerOptions& options);

/// How long one slice, and a whole scan, take [s].
double AisSliceDuration(const AisScannerOptions& options);
double AisScanDuration(const AisScannerOptions& options);

/// One 3D scan that starts at `start_time` [s], of a robot that stands. The tilt runs on during a slice,
/// and each beam has its own pitch and time; moving bodies are seen where they are at that time. Slices are
/// stamped with their time, and the odometry is left to the robot. `scan_number` tells the scans of a run
/// apart: it names the streams of noise, so that the result depends neither on threads nor on other scans.
slam::Scan TakeAisScan(const RayScene& scene, const slam::Pose3& T_map_base, double start_time,
                       const AisScannerOptions& options, std::uint64_t seed, std::uint64_t scan_number,
                       const Parallel& parallel);

/// One sweep in horizontal mode, the tilt fixed at 0 (Sec. 5.3), from `start_time` on, also while driving:
/// `T_map_base` is the base's way; see Standing(). `sweep_number` names the streams of noise.
slam::LaserSweep TakeAisSweep(const RayScene& scene, const Motion& T_map_base, double start_time,
                              const AisScannerOptions& options, std::uint64_t seed,
                              std::uint64_t sweep_number);

}  // namespace ariadne::drivers
