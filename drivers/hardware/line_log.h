#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/hardware/line_log_stream.h"

namespace ariadne::drivers {

/// The number of the line of notes, which is none.
constexpr std::uint8_t kNotesLine = 255;

/// Writes what crosses lines to files, `name.000`, `name.001` ... of limited size, each of which can be
/// read by itself; see LineLogEncoder for what is in them. A record is with the system before Add returns,
/// so that a killed program loses none of them, and a computer without power the last ones. Error where
/// the disk does not take it, then and on each further call.
class LineLogWriter {
 public:
  /// Begins a new log. Error if there is one of this name.
  explicit LineLogWriter(std::filesystem::path name, std::uintmax_t max_file_size = 64U << 20U);

  /// `line` is the number by which records of a line are found again.
  void Add(std::uint8_t line, const LineRecord& record);

  /// What no line says, and a replay must know, at the time of the last record.
  void Note(std::string_view text);

 private:
  void Open();
  void Put(ByteView bytes);

  std::filesystem::path name_;
  std::uintmax_t max_file_size_;
  std::uintmax_t size_ = 0;  // of the file that is being written [B]
  int files_ = 0;
  bool failed_ = false;
  double last_time_ = 0.0;  // of a record [s]
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
  LineLogEncoder encoder_;
};

/// One of the files of a log, from 0 on.
std::filesystem::path LineLogFile(const std::filesystem::path& name, int number);

/// What a log is made of.
struct LineLogFiles {
  int files = 0;
  std::uintmax_t size = 0;  // of all of them [B]
  std::uintmax_t torn = 0;  // behind the last whole record [B]
  std::size_t records = 0;
};

/// Reads the records of a log in the order in which they were written, from all of its files; only one of
/// these is in memory at a time. What follows the last whole record of the last file was torn by the end of
/// the program, and is left out. Error where a file is damaged before its end, or missing.
class LineLogReader {
 public:
  explicit LineLogReader(std::filesystem::path name);

  /// None at the end, and from then on.
  std::optional<LoggedRecord> Next();

  /// What was read; all of it at the end.
  const LineLogFiles& files() const { return log_; }

 private:
  void Open();
  void Close();

  std::filesystem::path name_;
  LineLogFiles log_;
  Bytes content_;                            // of a file
  std::unique_ptr<LineLogDecoder> decoder_;  // none behind the end
};

/// Shows all records of a log, as LineLogReader reads them.
LineLogFiles VisitLineLog(const std::filesystem::path& name,
                          const std::function<void(const LoggedRecord&)>& visit);

/// All records of each line, and the notes.
std::map<std::uint8_t, std::vector<LineRecord>> ReadLineLog(const std::filesystem::path& name);

/// The names of the logs that a path means: it may be that of a log, of one of its files, or of a folder,
/// then all logs in it, sorted. Error where there are none.
std::vector<std::filesystem::path> FindLineLogs(const std::filesystem::path& path);

}  // namespace ariadne::drivers
