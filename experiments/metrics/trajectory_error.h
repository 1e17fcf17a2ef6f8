#pragma once

#include <vector>

#include "experiments/metrics/statistics.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

using Trajectory = std::vector<slam::Pose3>;

/// Errors of a trajectory against the true one; the k-th pose belongs to the k-th true pose.
/// By the definitions of evo (github.com/MichaelGrupp/evo, core/metrics.py) throughout: of an error E in
/// SE(3) the "translation part" |trans(E)| and the "rotation angle" |log rot(E)|, and its statistics.
struct TrajectoryError {
  Summary translation;  // [m]
  Summary rotation;     // [rad]
};

/// Absolute, without alignment: both trajectories in the frame of their first pose, that of the master
/// scan, E_k = (P_0^-1 P_k)^-1 (Q_0^-1 Q_k) for estimated P and true Q. An error of the first heading grows
/// with the distance, as it does in the map. Over all poses but the first, which is right by definition;
/// `evo_ape --align_origin` counts it, so its rms is ours times sqrt((n - 1) / n).
TrajectoryError ErrorFromMaster(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true);

/// Absolute, aligned: E_k = (A P_k)^-1 Q_k over all poses, where A is the rigid motion with the least
/// sum |A trans(P_k) - trans(Q_k)|^2 (Horn; Umeyama 1991 without scale). The translation's rms is the ATE
/// of `evo_ape -a`, the rotation that of `evo_ape -a -r angle_rad`.
struct AlignedError {
  TrajectoryError error;
  slam::Pose3 T_true_map;  // A
  bool unique = false;     // false where all positions are on a line: the turn about it, and with it the
                           // rotation error, is arbitrary. In a straight corridor look at ErrorFromMaster.
};

AlignedError ErrorAligned(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true);

struct RelativeErrorOptions {
  std::size_t delta = 1;   // poses from the first to the second of a pair
  bool all_pairs = false;  // every (i, i + delta), as --all_pairs; else (0, delta), (delta, 2 delta) ...
};

/// Relative (RPE): E = (Q_i^-1 Q_j)^-1 (P_i^-1 P_j) over pairs (i, j = i + delta), as
/// `evo_rpe --delta DELTA --delta_unit f`. Each pair counts alike, wherever the trajectory has drifted.
TrajectoryError ErrorRelative(const Trajectory& T_map_laser, const Trajectory& T_map_laser_true,
                              const RelativeErrorOptions& options = {});

/// What a trajectory has cost.
struct PathStatistics {
  std::size_t scans = 0;  // poses: the robot stops at each and scans
  double length = 0.0;    // sum |trans(P_k) - trans(P_k-1)|, the straight lines between the stops [m]
  double turned = 0.0;    // sum of the angles of P_k-1^-1 P_k [rad]
};

PathStatistics MeasurePath(const Trajectory& T_map_laser);

}  // namespace ariadne::experiments
