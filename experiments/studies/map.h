#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/model_options.h"

namespace ariadne::experiments {

/// The experiment `map`: the registered scans of a run into a model of the building (Sec. 6).
struct MapStudyOptions {
  std::string run;
  ModelOptions model;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("run", self.run, "directory of a run of `register`, whose scans and poses are taken");
    ModelOptions::Visit(self.model, visit);
  }
};

/// An Error where the run is not there.
void CheckMapInput(const MapStudyOptions& options);

/// Writes the model in all its forms; returns what to print.
std::string RunMap(const MapStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments
