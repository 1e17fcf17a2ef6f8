#pragma once

#include <string>
#include <vector>

#include "slam/matching/scan_graph.h"
#include "slam/registration/align.h"

namespace ariadne::slam {

/// A scan that the new one may overlap, although it does not where the two are now.
struct ClosureCandidate {
  std::size_t scan = 0;
  Pose3::Square covariance = Pose3::Square::Zero();  // of T_scan_new, by the graph
  double radius = 0.0;                               // three sigma of the position [m]
  std::size_t pairs = 0;                             // the overlap, with a gate that is wider by the radius
};

/// A candidate that was aligned.
struct Closure {
  std::size_t from = 0;            // the earlier scan
  std::size_t to = 0;              // the new one
  AlignResult align;               // in map coordinates: align.T_model_data is T_map_laser of `to`
  double squared_distance = 0.0;   // of Mahalanobis, from what the graph predicts
  double moved_translation = 0.0;  // by the alignment [m]
  bool accepted = false;
  std::string verdict;  // why, with numbers
};

/// The earlier scans to which the last one could be closed: not joined to it, within reach at three sigma
/// of their relative position, and so uncertain that they may overlap unnoticed, that is by more than the
/// gate. The one with the largest overlap in the wider gate is first.
std::vector<ClosureCandidate> ProposeClosures(const ScanMap& map, const MatchOptions& match,
                                              const AlignOptions& align, const Parallel& parallel);

/// Aligns the last scan to the candidate, from as far as the graph leaves open, and judges what comes out
/// by the share of pairs, their rms, and its consistency with the graph. Moves nothing.
Closure TryClosure(ScanMap& map, const ClosureCandidate& candidate, const MatchOptions& match,
                   const AlignOptions& align, const Parallel& parallel);

}  // namespace ariadne::slam
