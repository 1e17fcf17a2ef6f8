#pragma once

#include <functional>
#include <memory>

#include "drivers/replay/log_cursor.h"
#include "drivers/replay/logged_robot.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

/// The log has no further answer, and nobody goes on with it.
class LogEnded : public Error {
 public:
  using Error::Error;
};

/// What lies between the end of a log and the robot that goes on.
enum class Seam {
  kRestarted,  // a robot that was started anew: its clock and odometry are taken on, see ContinuedRobot
  kNone        // the robot is where the log ends, as after FastForward(): its answers are passed unchanged
};

/// Who answers when the log ends.
struct LiveRobot {
  std::function<Robot&()> robot;  // asked for once, at the end of the log
  Seam seam = Seam::kRestarted;
  RobotLogWriter* log = nullptr;  // that goes on with the log; null: nobody records
};

/// A robot that answers from a log, as long as it is asked what the log was asked, and lets a living robot
/// go on from there. So a mission that was killed is resumed: run the same code once more on
///     RobotLog log = ReadRobotLog(path);
///     RobotLogWriter more(path);
///     ReplayRobot robot(log, {[&]() -> Robot& { return live; }, Seam::kRestarted, &more});
/// A call that differs from the log's, in its kind or in any bit of its argument, is an Error that says
/// where; the robot does not move then.
class ReplayRobot : public LoggedRobot {
 public:
  /// Keeps a reference to the log. Without `live.robot` the end of the log is a LogEnded.
  explicit ReplayRobot(RobotLog& log, LiveRobot live = {});
  ~ReplayRobot() override;

  /// Nothing happens while the log lasts, whatever its notes say; then it goes to the new log.
  void Note(std::string_view text) override;

  /// Whether the log still has answers.
  bool Replayed() const { return CallsLeft() > 0; }
  /// For a display of progress.
  std::size_t CallsLeft() const { return cursor_.left(); }

 private:
  struct Continuation;

  Robot* Live() const;
  RobotCall Answer(RobotCall asked) const override;

  mutable LogCursor cursor_;
  LiveRobot live_;
  mutable std::unique_ptr<Continuation> continuation_;  // behind the end of the log
};

}  // namespace ariadne::drivers
