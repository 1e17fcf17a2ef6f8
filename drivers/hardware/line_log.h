#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/hardware/recorded_stream.h"

namespace ariadne::drivers {

/// Writes what crosses lines to files, `name.0`, `name.1` ... of limited size. Each record is framed, has a
/// checksum, and is with the system before Add returns, so that a killed program loses none of them, and a
/// computer without power the last ones. Error where the disk does not take it.
class LineLogWriter {
 public:
  /// Begins a new log. Error if there is one of this name.
  explicit LineLogWriter(std::filesystem::path name, std::uintmax_t max_file_size = 64U << 20U);

  /// `line` is the number by which records of a line are found again.
  void Add(std::uint8_t line, const LineRecord& record);

 private:
  void Open();

  std::filesystem::path name_;
  std::uintmax_t max_file_size_;
  std::uintmax_t size_ = 0;  // of the file that is being written [B]
  int files_ = 0;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
};

/// All records of each line, from all files of a log. What follows the last whole record of the last file
/// was torn by the end of the program, and is left out. Error where a file is damaged before its end, or
/// missing.
std::map<std::uint8_t, std::vector<LineRecord>> ReadLineLog(const std::filesystem::path& name);

// The bytes of a record in a file, and the same read back; none where they are torn or damaged.
Bytes EncodeLineRecord(std::uint8_t line, const LineRecord& record);
struct DecodedLineRecord {
  std::uint8_t line = 0;
  LineRecord record;
  std::size_t size = 0;  // in the file [B]
};
std::optional<DecodedLineRecord> DecodeLineRecord(ByteView bytes);

}  // namespace ariadne::drivers
