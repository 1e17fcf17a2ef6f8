#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/replay/robot_call.h"
#include "slam/io/descriptor_buffer.h"

namespace ariadne::drivers {

/// The log of a run: all calls to the robot in their order, with its answers. A mission is a function of
/// these answers, so that its log is its journal: see ReplayRobot.
///
/// The file, all numbers little-endian:
///     8 bytes  "ARIADLOG"
///     uint32   version: 1
///     records, until the end of the file:
///       uint32   length of the payload [B], at least 1
///       uint32   CRC-32 (of zlib, Ethernet) of these four bytes of length and the payload
///       payload  uint8 kind as in CallKind, and its fields; plus 0x80 where these are compressed, and
///                then a uint32 with their size [B] and LZF
/// The fields, where f64 are IEEE numbers bit by bit, and a list is a uint32 count and its elements:
///     now            f64 time
///     mounting       pose: f64 quaternion w x y z, f64 translation x y z
///     scan           scanner, odometry, list of sweeps
///     sweep          sweep
///     safety sweeps  list of {pose, scanner, sweep}
///     state          f64 stamp, odometry, f64 forward, f64 turning, uint8 blocked
///     drive          f64 forward, f64 turning
///     wait           f64 until
///     note           text, to the end of the payload
///   scanner          f64 first_angle, f64 angle_step, int32 turns_per_sweep, f64 turn_period
///   odometry         f64 angle, f64 x, f64 y, 9 f64 covariance by rows
///   sweep            f64 stamp, f64 pitch, f64 pitch_rate, numbers ranges, numbers reflectance
///   numbers          uint32 count, uint8 coding, and what PackFloats says; each keeps its bits
/// With two safety scanners of 361 points and reflectance at 20 Hz a minute takes 1.4 to 1.8 MB, 7.4 MB as
/// f32, and 3.8 to 4.7 MB as f32 with LZF; a scan of 181 x 256 points 50 to 72 kB.
class RobotLog {
 public:
  /// Finds the records of a log; `name` is for messages. What is no log, or one of another version, is an
  /// Error. A log that breaks off is not: it ends with its last whole record. Damage is: a scan or a note
  /// that follows it was on the disk with all before it.
  RobotLog(std::unique_ptr<std::istream> file, std::string name);

  /// Whole records.
  std::size_t size() const { return records_.size(); }
  CallKind KindAt(std::size_t i) const { return records_[i].kind; }
  /// Reads a record from the file; they are not kept in memory.
  RobotCall Read(std::size_t i);

  /// Forgets the records behind the first `count`; the file keeps them.
  void Truncate(std::size_t count) {
    if (count < records_.size()) records_.resize(count);
  }

  const std::string& name() const { return name_; }
  /// The byte behind the last whole record.
  std::uint64_t end() const { return end_; }
  /// Where a record (or the head of the file) begins that was not written to its end; it does not count.
  std::optional<std::uint64_t> torn_at() const { return torn_at_; }

 private:
  struct Record {
    std::uint64_t offset;  // of the payload
    std::uint32_t length;
    CallKind kind;
  };
  void CheckHead(std::uint64_t file_size);
  bool FindRecord(std::uint64_t file_size);
  void CheckTail(std::uint64_t file_size);
  std::string_view BytesAt(std::uint64_t offset, std::size_t count);

  std::unique_ptr<std::istream> file_;
  std::string name_;
  std::vector<Record> records_;
  std::uint64_t position_ = 0;  // of the file
  std::vector<char> memory_;    // of the record that was read last
  std::uint64_t end_ = 0;
  std::optional<std::uint64_t> torn_at_;
};

/// Error where the file cannot be read or is no log.
RobotLog ReadRobotLog(const std::filesystem::path& path);

/// Keeps other programs from writing a log, and from driving its robot, as long as it lives. The system
/// ends it with the program.
class LogLock {
 public:
  explicit LogLock(const std::filesystem::path& path);
  ~LogLock();
  LogLock(const LogLock&) = delete;
  LogLock& operator=(const LogLock&) = delete;

 private:
  int descriptor_;  // negative: the file system has no locks
};

/// Writes a log record by record. What Append has returned from outlives the end of the program; scans and
/// notes, with all before them, outlive that of the system as well (fsync). Whatever cannot be written is
/// an Error with the path and the system's reason, then and on each further call.
class RobotLogWriter {
 public:
  /// Goes on at the end of a log that exists, without what is torn there; else begins one. Error where it
  /// is no log, where it is damaged, and while another program writes it.
  explicit RobotLogWriter(std::filesystem::path path);

  void Append(const RobotCall& call);

  /// Returns when the disk has everything.
  void Flush();

 private:
  void Write(std::string_view bytes);

  std::filesystem::path path_;
  slam::DescriptorBuffer file_;
  LogLock lock_;
  bool failed_ = false;
};

}  // namespace ariadne::drivers
