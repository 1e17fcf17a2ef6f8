#pragma once

#include <cstddef>
#include <vector>

#include "slam/matching/map_scan.h"
#include "slam/matching/match_options.h"

namespace ariadne::slam {

/// Which scans may move, and how long.
struct JointProblem {
  std::vector<bool> free;  // per scan; only registered ones move, and are moved to
  int max_iterations = 1;
  double convergence = 1e-4;  // ends when no pose moves by more [m and rad]
};

/// What came out.
struct JointSolution {
  std::vector<Pose3> T_map_laser;  // of all scans
  std::size_t scan_pairs = 0;      // that overlap, and of which one scan may move
  std::size_t pairs = 0;           // of points, in the last iteration
  double rms = 0.0;                // of their residuals before the last step [m]
  std::size_t iterations = 0;
  bool settled = false;
};

/// Multi-scan matching: pairs the points of all overlapping scans, finds the poses that make the errors of
/// all these pairs together small (in one problem, each two scans' pairs as one factor), and again, until
/// the poses settle. Scans overlap if they have more than overlap_pairs pairs where they are at the start.
/// The scans have the surfaces that the metric needs (RequireSurfaces).
JointSolution SolveJointly(const std::vector<MapScan>& scans, const JointProblem& problem,
                           const MatchOptions& match, const AlignOptions& align, const Parallel& parallel);

}  // namespace ariadne::slam
