#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/hardware/line_log_stream.h"

namespace ariadne::drivers {

/// The recording has no further call.
class LinesEnded : public Error {
 public:
  using Error::Error;
};

/// Lines that answer once more what they answered when they were recorded, at the times of then. Who talks
/// over them must do the same as then, in the same order over all lines: the first call that is another one
/// is the departure. From then on, and behind the end, each call throws, since drivers survive single
/// errors.
class RecordedLines {
 public:
  /// `next` gives the records in their order, and none at the end, and from then on.
  RecordedLines(std::string name, std::function<std::optional<LoggedRecord>()> next);

  /// Error where the log cannot be read, and with the calls where it is damaged before its end.
  explicit RecordedLines(const std::filesystem::path& log);

  /// The line of a number, which must outlive neither these lines nor be opened out of its turn.
  std::unique_ptr<ByteStream> Open(std::uint8_t line);

  /// Calls that were made once more.
  std::size_t repeated() const { return repeated_; }
  /// Of the last of them [s].
  double time() const { return time_; }
  /// What was recorded, and what was done instead; empty for nothing.
  const std::string& departure() const { return departure_; }

  /// After the last call: a departure where the recording goes on.
  void ExpectEnd();

 private:
  class Line;

  LineRecord Repeat(std::uint8_t line, const LineRecord& asked);
  std::optional<LoggedRecord> NextCall();
  std::string NameOf(std::uint8_t line) const;
  void Depart(const LoggedRecord& recorded, const std::string& instead);

  std::string name_;
  std::function<std::optional<LoggedRecord>()> next_;
  std::map<std::uint8_t, std::string> names_;
  std::size_t repeated_ = 0;
  double time_ = 0.0;
  std::string departure_;
};

/// A recording of one line alone, of number 0, that begins with its opening.
RecordedLines OneRecordedLine(std::vector<LineRecord> records);

}  // namespace ariadne::drivers
