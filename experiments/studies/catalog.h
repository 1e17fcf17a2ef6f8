#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/config/options_io.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// A kind of experiment: what the key `experiment` of a config names.
struct Study {
  std::string name;
  std::string summary;
  std::function<std::vector<OptionDescription>()> describe;
  std::function<std::string()> defaults;  // as YAML
  std::function<std::string(const OptionEntries&)>
      resolve;  // all options as YAML; an Error for what is wrong
  /// Runs it; returns what to print at the end.
  std::function<std::string(const OptionEntries&, const RunDirectory&, ProgressDisplay&)> run;
};

const std::vector<Study>& AllStudies();

/// Error with the names that exist for any other.
const Study& FindStudy(const std::string& name);

}  // namespace ariadne::experiments
