#pragma once

#include "slam/graph/optimize/optimize.h"
#include "slam/graph/simulated_graph.h"

namespace ariadne::experiments {

/// Root mean square distance of the poses from the truth; both have the first pose in common [m].
double PositionRms(const slam::PoseGraph3& graph, const std::vector<slam::Pose3>& truth);

/// How well closures were told apart: shares of the wrong ones that were kept, and of the right ones that
/// were rejected (a weight below one half).
struct ClosureVerdicts {
  std::size_t wrong = 0, wrong_kept = 0;
  std::size_t right = 0, right_rejected = 0;
};

ClosureVerdicts JudgeClosures(const slam::SimulatedGraph<slam::Pose3>& simulated,
                              const std::vector<double>& edge_weights);

/// A graph of which a share of the closures is wrong, with every kernel.
struct RobustTrial {
  double wrong_share = 0.0;
  std::uint64_t seed = 0;
  std::string kernel;
  double position_rms = 0.0;   // [m]
  double reference_rms = 0.0;  // of the same graph without its wrong closures, without kernel [m]
  ClosureVerdicts verdicts;
};

std::vector<RobustTrial> TryKernels(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options,
                                    double wrong_share, std::uint64_t seed);

/// A graph at a level of noise, from every start, in SE-Sync's objective, and whether it is proven to be
/// the minimum; and the honesty of the covariances at the minimum of the full objective.
struct StartTrial {
  double noise = 1.0;
  std::uint64_t seed = 0;
  std::string start;
  double objective = 0.0;
  bool certified = false;
  int factorizations = 0;
  double position_rms = 0.0;  // [m]
  double nees = 0.0;          // of the last pose, of the full objective; of the first start only
};

std::vector<StartTrial> TryStarts(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options,
                                  double noise, std::uint64_t seed);

/// What a graph of some size costs.
struct SizeTrial {
  int poses = 0;
  std::uint64_t seed = 0;
  std::size_t edges = 0;
  double factor_bytes = 0.0;        // of the Cholesky factor, the largest thing in memory
  double optimize_seconds = 0.0;    // not deterministic
  double certify_seconds = 0.0;     // not deterministic
  double covariance_seconds = 0.0;  // not deterministic
};

SizeTrial TrySize(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options, int poses,
                  std::uint64_t seed);

}  // namespace ariadne::experiments
