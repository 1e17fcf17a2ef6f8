#pragma once

#include "experiments/run/office_scans.h"
#include "experiments/studies/catalog.h"
#include "tests/slam/io/support.h"

/// Experiments on coarse scans of the office, which take milliseconds.
namespace ariadne::experiments {

inline OptionEntries SmallOffice(const std::vector<std::string>& assignments = {}) {
  OptionEntries entries;
  for (const char* assignment : {"input.office.beams=61", "input.office.slices=48", "input.last=1"}) {
    entries.Set(assignment);
  }
  for (const std::string& assignment : assignments) entries.Set(assignment);
  return entries;
}

/// Runs an experiment in a folder of its own.
class StudyTest : public testing::Test {
 protected:
  StudyResult Run(const std::string& study, const OptionEntries& entries, const std::string& name = "run",
                  RunDirectory::Existing existing = RunDirectory::Existing::kRefuse) {
    ProgressDisplay silent(true);
    return FindStudy(study).run(entries, RunDirectory(folder_ / name, existing), silent);
  }
  std::string Content(const std::string& file) const {
    return slam::testing_support::ContentOf(folder_ / file);
  }
  Json ReadJson(const std::string& file) const { return Json::parse(Content(file)); }

  slam::testing_support::TemporaryFolder folder_;
};

}  // namespace ariadne::experiments
