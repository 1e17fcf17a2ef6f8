#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "experiments/mission/next_drive.h"

namespace ariadne::experiments {

/// What decides a mission and is no answer of a device. It is noted in the log of the lines, so that a
/// replay repeats it.
struct RunNotes {
  std::uint64_t stopped_at = 0;  // the question whether to stop that was answered with yes, from 1; 0: none
  std::uint64_t refused_at = 0;  // the plan that was not approved, from 1; 0: none
  std::uint64_t resumed_after = 0;  // records of robot.log from which the run went on

  bool operator==(const RunNotes&) const = default;
};

/// The note of each.
std::string StoppedNote(std::uint64_t question);
std::string RefusedNote(std::uint64_t plan);
std::string ResumedNote(std::uint64_t records);

/// Error where the log is damaged before its end.
RunNotes ReadRunNotes(const std::filesystem::path& line_log);

/// What robot.log has of a plan.
std::string NoteOf(const PlannedDrive& drive);

/// Who can stop a mission, and may have to approve plans; the answers that end a mission are noted once.
class AskedPerson {
 public:
  using Stop = std::function<bool()>;                        // may be empty
  using Approve = std::function<bool(const PlannedDrive&)>;  // empty: nobody is asked
  using WriteNote = std::function<void(const std::string&)>;

  AskedPerson(Stop stop, Approve approve) : stop_(std::move(stop)), approve_(std::move(approve)) {}

  /// Where notes go from now on; empty: nowhere.
  void NoteTo(WriteNote note) { note_ = std::move(note); }

  /// Once true it stays so.
  bool MustStop();

  bool approves_plans() const { return approve_ != nullptr; }
  bool Approves(const PlannedDrive& drive);

 private:
  Stop stop_;
  Approve approve_;
  WriteNote note_;
  std::uint64_t questions_ = 0, plans_ = 0;
  bool stopped_ = false;
};

/// One who answers as those did who were noted.
AskedPerson AnsweringAs(const RunNotes& notes);

}  // namespace ariadne::experiments
