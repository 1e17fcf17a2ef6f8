#include "drivers/replay/replay_robot.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "drivers/replay/continued_robot.h"
#include "drivers/replay/recording_robot.h"

namespace ariadne::drivers {
namespace {

[[noreturn]] void FailDeparted(const LogCursor& cursor, const RobotCall& asked, const RobotCall& recorded) {
  Fail(
      "{}: the mission departs from its log at call {} ({:.3f} s): it asks for {}, and the log has {}; go "
      "on "
      "with the options and the version of the program that wrote the log",
      cursor.name(), cursor.position() + 1, cursor.last_known().time.value_or(0.0), Describe(asked),
      Describe(recorded));
}

}  // namespace

/// The living robot, in the log's time and odometry, and with the log that goes on.
struct ReplayRobot::Continuation {
  std::optional<ContinuedRobot> continued;
  std::optional<RecordingRobot> recording;
  Robot* robot = nullptr;
};

ReplayRobot::ReplayRobot(RobotLog& log, LiveRobot live) : cursor_(log), live_(std::move(live)) {}

ReplayRobot::~ReplayRobot() = default;

/// Null while the log lasts.
Robot* ReplayRobot::Live() const {
  cursor_.PassNotes();
  if (cursor_.left() > 0) return nullptr;
  if (continuation_) return continuation_->robot;
  if (!live_.robot)
    throw LogEnded(fmt::format("{}: the log ends after {} calls", cursor_.name(), cursor_.position()));
  auto next = std::make_unique<Continuation>();
  next->robot = &live_.robot();
  if (live_.seam == Seam::kRestarted)
    next->robot = &next->continued.emplace(*next->robot, cursor_.last_known());
  if (live_.log != nullptr) next->robot = &next->recording.emplace(*next->robot, *live_.log);
  continuation_ = std::move(next);
  return continuation_->robot;
}

RobotCall ReplayRobot::Answer(RobotCall asked) const {
  if (Robot* live = Live()) return MadeCall(*live, std::move(asked));
  RobotCall recorded = cursor_.Peek();
  if (!AskTheSame(asked, recorded)) FailDeparted(cursor_, asked, recorded);
  cursor_.Pass(recorded);
  return recorded;
}

void ReplayRobot::Note(std::string_view text) {
  if (cursor_.AtNote()) {
    cursor_.PassNote();
  } else if (cursor_.left() == 0 && live_.log != nullptr) {
    live_.log->Append(drivers::Note{std::string(text)});
  }
}

}  // namespace ariadne::drivers
