#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slam/matching/loop_closure.h"
#include "slam/matching/map_scan.h"
#include "slam/matching/match_options.h"
#include "slam/matching/scan_graph.h"
#include "slam/registration/align.h"

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

/// One optimization of several poses at once: a line of the log of what moved.
struct MatchPass {
  std::string of;         // "graph" or "joint"
  std::size_t scans = 0;  // that could move
  std::size_t links = 0;  // edges of the graph, or overlapping pairs of scans
  std::size_t pairs = 0;  // joint: point pairs at the end
  double rms = 0.0;       // joint: of their residuals before the last step [m]
  std::size_t iterations = 0;
  double moved_translation = 0.0;  // the largest of a scan [m]
  double moved_rotation = 0.0;     // [rad]
  bool settled = false;            // false: the iterations were not enough
};

/// How a new scan was matched.
struct MatchResult {
  bool registered = false;
  Pose3 T_map_laser_guess;        // from which it was matched
  std::string message;            // why not, or how the last step ended
  std::vector<MatchStep> steps;   // in order; the first is the alignment of the new scan
  std::vector<Closure> closures;  // graph and joint: that were tried
  std::vector<MatchPass> passes;  // graph and joint
};

/// Called before each alignment, and after each of its iterations, for a display of the progress.
struct MatchProgress {
  std::size_t scan = 0;
  std::size_t queued = 0;  // scans still in the queue
  const AlignIteration* iteration = nullptr;
};
using MatchCallback = std::function<void(const MatchProgress&)>;

/// Registers the last of the map's scans to those before it, and moves its pose (and with kSimultaneous,
/// kGraph and kJoint others' poses too, but never that of the first scan, the master). Every scan starts at
/// its T_map_laser.
MatchResult MatchNewScan(ScanMap& map, const MatchOptions& match, const AlignOptions& align,
                         const MatchCallback& on_progress = {});

/// Moves the poses of all scans once more, when no more scans come: kJoint makes them agree with each other
/// all at once. The other methods leave them.
MatchResult FinishMatching(ScanMap& map, const MatchOptions& match, const AlignOptions& align);

}  // namespace ariadne::slam
