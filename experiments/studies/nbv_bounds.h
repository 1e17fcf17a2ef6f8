#pragma once

#include <string>

#include "experiments/run/run_directory.h"
#include "experiments/studies/nbv_trials.h"

namespace ariadne::experiments {

/// The fewest views of floors as a run leaves them in bounds.json: the search takes a minute on a large
/// floor, and does not depend on what explores it.
class NbvBounds {
 public:
  /// Of floors that are prepared with these options.
  NbvBounds(const NbvFloorOptions& options, const FloorScannerOptions& scanner);

  /// Adds what a run has left. Error where it has no bounds, or searched for them with other options.
  void Read(const std::string& run_directory);

  /// What has been read of this very floor, or else is found now.
  const FloorBound& Of(const NbvFloor& floor, const Parallel& parallel);

  /// Of all floors that were asked for.
  void Write(const RunDirectory& run) const { run.WriteJson("bounds.json", json_); }

 private:
  NbvFloorOptions options_;
  FloorScannerOptions scanner_;
  Json known_ = Json::object();  // what was read, by floor
  Json json_;                    // what is written
  FloorBound bound_;             // of the last floor
};

}  // namespace ariadne::experiments
