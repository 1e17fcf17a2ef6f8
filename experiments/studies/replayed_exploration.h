#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/explore.h"
#include "experiments/studies/run_notes.h"

namespace ariadne::experiments {

/// One start of an exploration whose lines are on a log.
struct RecordedStart {
  std::filesystem::path run;  // its directory
  std::filesystem::path log;  // of the lines
  RunNotes notes;
  bool last = true;                 // no later start went on from here
  std::uint64_t robot_records = 0;  // of robot.log up to its end, where it is not the last
};

/// The starts whose logs a path means (see FindLineLogs), in their order. Error where the folder is none of
/// an exploration, or a log is damaged.
std::vector<RecordedStart> FindRecordedStarts(const std::filesystem::path& path);

struct ReplayResult {
  std::size_t line_calls = 0;   // that were the same, over all lines
  std::size_t robot_calls = 0;  // of robot.log
  std::size_t stops = 0;        // scans with all that was decided after them
  double time = 0.0;            // of the lines, at the end [s]
  std::string end;              // why it ended
  std::string departure;        // what was recorded, and what is decided now; empty: all is the same
};

/// Runs the drivers of the robot and the mission once more on what the devices said. What the drivers write
/// must be what they wrote; each call of the mission, with the answer that the drivers make of the lines,
/// must be that of robot.log; and what is known and planned after each scan that of steps/. It ends at the
/// first difference, or where the recording ends.
ReplayResult ReplayExploration(const RecordedStart& start, const ExploreStudyOptions& options,
                               ProgressDisplay& progress);

}  // namespace ariadne::experiments
