#include "experiments/studies/run_notes.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "drivers/hardware/line_log.h"

namespace ariadne::experiments {
namespace {

constexpr std::string_view kStopped = "stopped at question ";
constexpr std::string_view kRefused = "refused plan ";
constexpr std::string_view kResumed = "resumed after record ";

/// The number behind a beginning; none where the note is another one.
std::optional<std::uint64_t> NumberBehind(std::string_view note, std::string_view beginning) {
  if (!note.starts_with(beginning)) return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, error] =
      std::from_chars(note.data() + beginning.size(), note.data() + note.size(), number);
  if (error != std::errc() || end != note.data() + note.size()) return std::nullopt;
  return number;
}

}  // namespace

std::string StoppedNote(std::uint64_t question) { return fmt::format("{}{}", kStopped, question); }
std::string RefusedNote(std::uint64_t plan) { return fmt::format("{}{}", kRefused, plan); }
std::string ResumedNote(std::uint64_t records) { return fmt::format("{}{}", kResumed, records); }

RunNotes ReadRunNotes(const std::filesystem::path& line_log) {
  RunNotes notes;
  drivers::VisitLineLog(line_log, [&notes](const drivers::LoggedRecord& logged) {
    if (logged.record.kind != drivers::LineRecord::Kind::kNote) return;
    const std::string text = TextOf(logged.record);
    notes.stopped_at = NumberBehind(text, kStopped).value_or(notes.stopped_at);
    notes.refused_at = NumberBehind(text, kRefused).value_or(notes.refused_at);
    notes.resumed_after = NumberBehind(text, kResumed).value_or(notes.resumed_after);
  });
  return notes;
}

std::string NoteOf(const PlannedDrive& drive) {
  if (!drive.view) return "drive back";
  return fmt::format("drive to ({:.3f}, {:.3f}) m for {} rays", drive.view->p_map.x(),
                     drive.view->p_map.y(), drive.view->gain);
}

bool AskedPerson::MustStop() {
  ++questions_;
  if (stopped_ || !stop_ || !stop_()) return stopped_;
  stopped_ = true;
  if (note_) note_(StoppedNote(questions_));
  return true;
}

bool AskedPerson::Approves(const PlannedDrive& drive) {
  ++plans_;
  if (!approve_ || approve_(drive)) return true;
  if (note_) note_(RefusedNote(plans_));
  return false;
}

AskedPerson AnsweringAs(const RunNotes& notes) {
  return {[at = notes.stopped_at, question = std::uint64_t{0}]() mutable { return ++question == at; },
          [at = notes.refused_at, plan = std::uint64_t{0}](const PlannedDrive&) mutable {
            return ++plan != at;
          }};
}

}  // namespace ariadne::experiments
