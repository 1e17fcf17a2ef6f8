#pragma once

#include <filesystem>

#include "experiments/studies/explore_steps.h"

namespace ariadne::experiments {

/// What a run of `explore` knew and planned, to be compared with what another one does. Each difference is
/// a drivers::DepartedFromLog that says what was recorded. Of what the run has not kept nothing is said.
class RecordedDecisions {
 public:
  explicit RecordedDecisions(std::filesystem::path run) : run_(std::move(run)) {}

  /// Where the robot was by then.
  void CompareStop(const ExploredStep& step) const;
  /// And what was planned from there.
  void ComparePlan(const ExploredStep& step) const;
  /// Why and when the mission ended.
  void CompareEnd(const MissionResult& result) const;

 private:
  Json Recorded(const std::string& file) const;

  std::filesystem::path run_;
};

}  // namespace ariadne::experiments
