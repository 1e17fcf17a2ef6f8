#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/config/options_io.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// How an experiment has ended.
struct StudyResult {
  std::string text;          // to print
  std::string problem = {};  // a sentence, where it has ended, but not well
};

/// A kind of experiment: what the key `experiment` of a config names.
struct Study {
  std::string name;
  std::string summary;
  std::function<std::vector<OptionDescription>()> describe;
  std::function<std::string()> defaults;  // as YAML
  std::function<std::string(const OptionEntries&)>
      resolve;                                            // all options as YAML; an Error for what is wrong
  std::function<void(const OptionEntries&)> check_input;  // an Error where there are no such scans
  std::function<StudyResult(const OptionEntries&, const RunDirectory&, ProgressDisplay&)> run;
};

const std::vector<Study>& AllStudies();

/// Error with the names that exist for any other, and where it stands (file and line), if that is known.
const Study& FindStudy(const std::string& name, const std::string& where = "");

}  // namespace ariadne::experiments
