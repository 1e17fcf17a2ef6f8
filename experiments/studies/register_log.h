#pragma once

#include <string>
#include <vector>

#include "experiments/report/table.h"
#include "experiments/run/run_directory.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// All that a registration has come to so far: tables for its readers, and the poses that a resumed run
/// starts from.
struct RegisterLog {
  RegisterLog();

  /// Adds what AddScan() has returned for the last scan of the mapper. `points` are those within range.
  void Add(const slam::Mapper& mapper, const slam::MatchResult& result, std::size_t points,
           bool has_reflectance);

  /// Adds what Finish() has returned.
  void AddFinish(const slam::Mapper& mapper, const slam::MatchResult& result);

  Table scans;                           // a line per scan
  Table steps;                           // a line per alignment: what was aligned to what, and what moved
  Table iterations;                      // a line per iteration of each alignment
  Table covariances;                     // a line per alignment: the covariance of T_map_laser
  Table closures;                        // a line per closure that was tried
  Table passes;                          // a line per optimization of many poses at once
  slam::ScanGraph graph;                 // what the methods graph and joint know
  std::vector<slam::Pose3> T_map_laser;  // of all scans so far
  std::vector<bool> registered;
  std::vector<std::size_t> points;  // within range, per scan
  bool has_reflectance = true;      // of all scans so far

 private:
  void AddPasses(const slam::Mapper& mapper, const slam::MatchResult& result);
};

Json ToJson(const RegisterLog& log);
RegisterLog RegisterLogFromJson(const Json& json);

}  // namespace ariadne::experiments
