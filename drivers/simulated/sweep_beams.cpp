#include "drivers/simulated/sweep_beams.h"

#include <cmath>
#include <numbers>

namespace ariadne::drivers {
namespace {

/// Where the mirror's centre is in the laser frame at a pitch, which is positive upwards [rad].
Eigen::Vector3d MirrorAt(const SweepMounting& mounting, double pitch) {
  const double forward = mounting.mirror_forward;
  const double up = mounting.mirror_up;
  return {forward * std::cos(pitch) - up * std::sin(pitch), 0.0,
          forward * std::sin(pitch) + up * std::cos(pitch)};
}

}  // namespace

Motion Standing(const slam::Pose3& T_map_body) { return {{0.0}, {T_map_body}}; }

slam::ScannerModel HalfCircle(int turns) {
  slam::ScannerModel scanner;
  scanner.turns_per_sweep = turns;
  scanner.angle_step = std::numbers::pi / (180.0 * turns);
  return scanner;
}

std::size_t HalfCircleBeams(int turns) { return 180 * static_cast<std::size_t>(turns) + 1; }

std::vector<Ray> SweepBeams(const SweepMounting& mounting, const Motion& T_map_base, double stamp,
                            double pitch, double pitch_rate) {
  slam::Pose3 T_map_laser = PoseAt(T_map_base, stamp) * mounting.T_base_laser;
  Eigen::Matrix3d R_map_laser = T_map_laser.RotationMatrix();
  std::vector<Ray> beams(mounting.beams);
  for (std::size_t b = 0; b < beams.size(); ++b) {
    const double after_stamp = slam::BeamTime(mounting.scanner, b);
    const double beam_pitch = pitch + pitch_rate * after_stamp;
    if (T_map_base.moves()) {
      T_map_laser = PoseAt(T_map_base, stamp + after_stamp) * mounting.T_base_laser;
      R_map_laser = T_map_laser.RotationMatrix();
    }
    beams[b] = {T_map_laser.translation + R_map_laser * MirrorAt(mounting, beam_pitch),
                R_map_laser * slam::BeamDirection(mounting.scanner, b, beam_pitch), stamp + after_stamp};
  }
  return beams;
}

}  // namespace ariadne::drivers
