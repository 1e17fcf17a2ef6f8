#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slam/registration/align.h"
#include "slam/matching/map_scan.h"
#include "slam/matching/match_options.h"

namespace ariadne::slam {

/// One alignment of one scan to one or more others: a line of the log of what moved.
struct MatchStep {
  std::size_t scan = 0;               // that was aligned
  std::vector<std::size_t> partners;  // to whose points
  AlignResult align;                  // in map coordinates: align.T_model_data is T_map_laser
  double moved_translation = 0.0;     // by the alignment [m]
  double moved_rotation = 0.0;        // [rad]
  std::vector<std::size_t> requeued;  // simultaneous: neighbours appended to the queue because it moved
};

/// How a new scan was matched.
struct MatchResult {
  bool registered = false;
  Pose3 T_map_laser_guess;       // from which it was matched
  std::string message;           // why not, or how the last step ended
  std::vector<MatchStep> steps;  // in order; the first is the alignment of the new scan
};

/// Called before each alignment, and after each of its iterations, for a display of the progress.
struct MatchProgress {
  std::size_t scan = 0;
  std::size_t queued = 0;  // scans still in the queue
  const AlignIteration* iteration = nullptr;
};
using MatchCallback = std::function<void(const MatchProgress&)>;

/// Registers the last of `scans` to those before it, and moves its pose (and with kSimultaneous others'
/// poses too, but never that of the first scan, the master). Every scan starts at its T_map_laser.
MatchResult MatchNewScan(std::vector<MapScan>& scans, const MatchOptions& match, const AlignOptions& align,
                         const MatchCallback& on_progress = {});

}  // namespace ariadne::slam
