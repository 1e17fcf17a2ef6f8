#include "experiments/field/line_log_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "experiments/report/table.h"

namespace ariadne::experiments {
namespace {

using drivers::LineRecord;

/// A line while its records pass.
struct PassingLine {
  LineSummary summary;
  drivers::DeviceGuess guess;

  void Take(const LineRecord& record) {
    if (summary.records++ == 0) summary.first = record.time;
    summary.last = record.time;
    if (record.kind == LineRecord::Kind::kOpen) summary.name = TextOf(record);
    if (record.baud > 0) summary.rates.insert(record.baud);
    if (record.kind == LineRecord::Kind::kRead) summary.bytes_read += record.bytes.size();
    if (record.kind == LineRecord::Kind::kWrite) summary.bytes_written += record.bytes.size();
    guess.Take(record);
  }
};

std::string DeviceText(const drivers::DeviceGuess::Seen& seen) {
  if (seen.telegrams + seen.sent == 0) return "unknown";
  return std::string(NameOf(seen.kind));
}

}  // namespace

LineLogSummary SummarizeLineLog(const std::filesystem::path& name) {
  std::map<std::uint8_t, PassingLine> lines;
  LineLogSummary summary;
  summary.name = name;
  summary.files = drivers::VisitLineLog(name, [&](const drivers::LoggedRecord& logged) {
    if (logged.record.kind == LineRecord::Kind::kNote) {
      summary.notes.push_back(fmt::format("{:.3f} s: {}", logged.record.time, TextOf(logged.record)));
    } else {
      lines[logged.line].Take(logged.record);
    }
  });
  for (auto& [number, line] : lines) {
    line.summary.line = number;
    line.summary.seen = line.guess.Best();
    summary.lines.push_back(line.summary);
  }
  return summary;
}

std::string ToText(const LineLogSummary& summary) {
  const drivers::LineLogFiles& files = summary.files;
  std::string text = fmt::format("{}: {} files, {} bytes, {} records\n", summary.name.string(), files.files,
                                 files.size, files.records);
  text += files.torn == 0
              ? "whole to its end\n"
              : fmt::format("torn: the last {} bytes are no whole record, and left out\n", files.torn);
  Table table{{"line", "port", "device", "baud", "from s", "to s", "records", "bytes read", "written",
               "asked", "answered", "bad"},
              {}};
  for (const LineSummary& line : summary.lines) {
    table.rows.push_back({std::to_string(line.line), line.name, DeviceText(line.seen),
                          fmt::format("{}", fmt::join(line.rates, " ")), fmt::format("{:.3f}", line.first),
                          fmt::format("{:.3f}", line.last), std::to_string(line.records),
                          std::to_string(line.bytes_read), std::to_string(line.bytes_written),
                          std::to_string(line.seen.sent), std::to_string(line.seen.telegrams),
                          std::to_string(line.seen.bad)});
  }
  for (const std::string& note : summary.notes) text += fmt::format("note at {}\n", note);
  return text + "\n" + ToText(table);
}

}  // namespace ariadne::experiments
