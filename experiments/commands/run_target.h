#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// The flags that commands with a run directory share.
struct RunTarget {
  std::string out;
  bool overwrite = false;
  bool resume = false;
  bool quiet = false;

  RunDirectory::Existing existing() const;
};

void AddRunFlags(CLI::App& command, RunTarget& target);

/// --set key=value, any number of times.
void AddSetFlag(CLI::App& command, std::vector<std::string>& assignments);

}  // namespace ariadne::experiments
