#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/line_log.h"

namespace ariadne::experiments {

/// What one line of a log carried.
struct LineSummary {
  std::uint8_t line = 0;
  std::string name;     // as it was opened
  std::set<int> rates;  // [baud]
  double first = 0.0;   // of the line's clock [s]
  double last = 0.0;    // [s]
  std::size_t records = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t bytes_written = 0;
  drivers::DeviceGuess::Seen seen;  // what is on it, and its telegrams
};

struct LineLogSummary {
  std::filesystem::path name;
  drivers::LineLogFiles files;
  std::vector<LineSummary> lines;  // in the order of their numbers
  std::vector<std::string> notes;  // with their times
};

/// Error where the log is damaged before its end.
LineLogSummary SummarizeLineLog(const std::filesystem::path& name);

/// For people: a table of the lines, and what is torn.
std::string ToText(const LineLogSummary& summary);

}  // namespace ariadne::experiments
