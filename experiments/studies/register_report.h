#pragma once

#include "experiments/run/scan_source.h"
#include "experiments/studies/register_log.h"
#include "experiments/studies/register_options.h"

namespace ariadne::experiments {

/// What a registration has come to, for the caller's last words.
struct RegisterSummary {
  Table table;  // a line per scan, with its time
  std::size_t scans = 0;
  std::size_t unregistered = 0;
  std::string residuals;  // a sentence
  std::string errors;     // a sentence, where the truth is known

  /// A sentence where scans are not registered; else empty.
  std::string Problem() const;
};

/// Measures the finished map, writes residuals.csv and metrics.json, and says it in words. match_seconds:
/// how long each scan has taken.
RegisterSummary ReportRegistration(const RegisterOptions& options, const ScanSource& source,
                                   const slam::Mapper& mapper, const RegisterLog& log,
                                   const std::vector<double>& match_seconds, const RunDirectory& run);

}  // namespace ariadne::experiments
